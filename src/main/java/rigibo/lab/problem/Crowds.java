package rigibo.lab.problem;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Errors of crowds, whose single runs are chaotic: the median over a few that differ a little. */
final class Crowds {

    private Crowds() {}

    /** The deepest overlap is what they are known by. */
    static Errors errors(List<CrowdWatch> crowds) {
        for (int i = 0; i < crowds.size(); i++) {
            if (crowds.get(i).isLost()) {
                return Errors.failed("something of crowd " + i + " fell through the floor");
            }
        }
        return Errors.of(median(crowds, CrowdWatch::deepest))
                .with("energy gained / start", median(crowds, CrowdWatch::gain));
    }

    static double median(List<CrowdWatch> crowds, ToDoubleFunction<CrowdWatch> of) {
        double[] sorted = crowds.stream().mapToDouble(of).toArray();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
