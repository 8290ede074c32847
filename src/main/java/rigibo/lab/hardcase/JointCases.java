package rigibo.lab.hardcase;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Cases of joints, J1 to J17. */
final class JointCases {

    private static final String IMPACTS =
            "Limits and contacts of joined bodies do not rebound, and an impact reaches the joints"
                    + " with the substep after it.";

    private JointCases() {}

    /** Those whose every figure is within its limit at GAME and at EXACT. */
    static List<HardCase> held() {
        return List.of(
                Swings.physicalPendulum(),
                Swings.doublePendulum(),
                HangingChains.catenary(),
                HangingChains.heavyBob(),
                Mechanisms.all(),
                HillCar.climb(),
                DrivenJoints.motor(),
                DrivenJoints.breaking());
    }

    /** Those whose truth is not yet reached in every figure. */
    static List<HardCase> open() {
        List<HardCase> cases = new ArrayList<>(JointCrowd.each());
        Collections.addAll(
                cases,
                Swings.pendulum(),
                SpringJoints.all(),
                HangingChains.bridge(),
                JointImpacts.cradle(IMPACTS),
                DrivenJoints.limit(IMPACTS),
                JointImpacts.rope(IMPACTS),
                JointLaws.all(),
                JointImpacts.struck(IMPACTS));
        return cases;
    }
}
