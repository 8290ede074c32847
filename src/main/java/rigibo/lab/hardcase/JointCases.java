package rigibo.lab.hardcase;

import java.util.ArrayList;
import java.util.List;

/** Cases of joints, J1 to J17. */
final class JointCases {

    private JointCases() {}

    /** Those whose every figure is within its limit at GAME and at EXACT. */
    static List<HardCase> held() {
        return List.of(
                Swings.pendulum(),
                Swings.physicalPendulum(),
                Swings.doublePendulum(),
                HangingChains.catenary(),
                HangingChains.heavyBob(),
                Mechanisms.all(),
                HillCar.climb(),
                SpringJoints.all(),
                DrivenJoints.motor(),
                DrivenJoints.limit(),
                DrivenJoints.breaking(),
                JointImpacts.cradle(),
                JointImpacts.rope(),
                JointImpacts.struck(),
                JointLaws.all());
    }

    /** Those whose truth is not yet reached in every figure. */
    static List<HardCase> open() {
        List<HardCase> cases = new ArrayList<>(JointCrowd.each());
        cases.add(HangingChains.bridge());
        cases.add(TautBridges.loaded());
        return cases;
    }
}
