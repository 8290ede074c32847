package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;

import java.util.List;

/** E150 a click during the cooldown; E152 a par that a stored solution beats. */
final class SolutionRules {

    private SolutionRules() {}

    static void check(LevelSketch sketch) {
        sketch.limits().ifPresent(limits -> check(sketch, limits.part()));
    }

    private static void check(LevelSketch sketch, Limits limits) {
        for (Located<Solution> solution : sketch.ways()) {
            List<Click> clicks = solution.part().clicks();
            for (int i = 1; i < clicks.size(); i++) {
                requireCooled(sketch.json(), solution, i, limits.cooldown());
            }
            if (clicks.size() < limits.par()) {
                String pointer = "/rules/par";
                sketch.json()
                        .error(
                                pointer,
                                () ->
                                        "E152 par is "
                                                + limits.par()
                                                + ", but "
                                                + solution.pointer()
                                                + " needs only "
                                                + clicks.size());
            }
        }
    }

    private static void requireCooled(
            Document json, Located<Solution> solution, int i, double cooldown) {
        double last = solution.part().clicks().get(i - 1).seconds();
        double next = solution.part().clicks().get(i).seconds();
        if (Steps.of(next) - Steps.of(last) < Steps.of(cooldown)) {
            String pointer = solution.pointer() + "/clicks/" + i + "/t";
            json.error(
                    pointer,
                    () ->
                            "E150 clicks at "
                                    + next
                                    + " s, during the cooldown that lasts until "
                                    + (last + cooldown)
                                    + " s");
        }
    }
}
