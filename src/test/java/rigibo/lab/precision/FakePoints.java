package rigibo.lab.precision;

import rigibo.lab.child.Work;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Timing;
import rigibo.lab.problem.Errors;
import rigibo.lab.problem.Problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Points that look like real ones, with numbers that can be followed by hand. */
final class FakePoints {

    static final List<Problem> PROBLEMS =
            List.of(
                    problem(
                            "R1",
                            "ballistic flight of 5 s",
                            "distance from the parabola / length of the way",
                            1e-10),
                    problem(
                            "R6",
                            "bounce with e = 0.8, apexes 1 to 5",
                            "greatest |apex − e²ⁿH| / H over 25 phases of the height",
                            1e-7),
                    problem("R9", "stacks of 10 and 20", "overlap / height", 1e-6));

    /** Only its words are asked for. */
    private static Problem problem(String id, String title, String error, double equalBelow) {
        return new Problem(id, title, error, equalBelow, List.of(), null);
    }

    private final List<Point> points = new ArrayList<>();
    private String problem = "R1";

    private FakePoints() {}

    /** A point of ours at a cost in s per simulated s. */
    static Point point(String name, Line line, double at, double step, double error, double cost) {
        return point("R1", RigiBoEngine.NAME, new Setting(name, line, at, step), error, cost);
    }

    static Point point(String problem, String engine, Setting setting, double error, double cost) {
        Errors errors =
                Double.isNaN(error) ? Errors.failed("a ball fell through") : Errors.of(error);
        return new Point(
                problem,
                engine,
                setting,
                errors.with("height (m)", 0.25),
                300,
                new Work(10, 6, 5, 40, 20),
                cost > 0 ? Optional.of(timing(cost * setting.step() * 1e6)) : Optional.empty());
    }

    private static Timing timing(double cpu) {
        return new Timing(10, cpu, 0.98 * cpu, 1.03 * cpu, 1.01 * cpu, 0);
    }

    /** Points of three problems. */
    static List<Point> all() {
        FakePoints fake = new FakePoints();
        fake.flight();
        fake.bounce();
        fake.stack();
        return fake.points;
    }

    private void flight() {
        problem = "R1";
        presets(new double[] {3e-17, 3e-17, 3e-17, 3e-17}, 40e-6);
        steps(Line.STEP, 3e-17, 0, 60e-6);
        steps(Line.STEP_EULER, 2.1e-3, 1, 50e-6);
        steps(Line.STEP_VERLET, 3e-16, 0, 52e-6);
        steps(Line.STEP_RK4, 5e-16, 0, 90e-6);
        peers(new double[] {1.7e-3, 4e-4}, 30e-6);
    }

    private void bounce() {
        problem = "R6";
        presets(new double[] {4e-2, 3e-5, 2.5e-7, 6e-10}, 20e-6);
        steps(Line.STEP, 5e-5, 0.1, 26e-6);
        steps(Line.STEP_DISCRETE, 0.3, 1, 15e-6);
        steps(Line.STEP_SPLIT, 4e-3, 2, 20e-6);
        add("step, impacts at its end, 1/15 s", Line.STEP_DISCRETE, 1.0 / 15, Double.NaN, 9e-6);
        double[] tolerances = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
        for (int i = 0; i < tolerances.length; i++) {
            double cost = 35e-6 * (1 + 0.12 * i);
            String name = String.format("impact tolerance %.0e", tolerances[i]);
            add(name, Line.TOLERANCE, tolerances[i], 0.3 * tolerances[i], cost);
        }
        add("search BISECTION", Line.SEARCH, 0, 3e-5, 48e-6);
        add("search ITP", Line.SEARCH, 0, 2.8e-5, 37e-6);
        peers(new double[] {0.27, Double.NaN}, 120e-6);
    }

    private void stack() {
        problem = "R9";
        presets(new double[] {Double.NaN, 4e-3, 6e-4, 2e-6}, 300e-6);
        sweep(Line.SUBSTEPS, new double[] {1, 2, 4, 8, 16, 32, 64}, 3e-2, 160e-6);
        sweep(Line.ITERATIONS, new double[] {1, 2, 3, 4, 6, 8}, 4e-3, 500e-6);
        add("contact solver SEQUENTIAL", Line.SOLVER, 0, 5e-3, 480e-6);
        add("contact solver BLOCK", Line.SOLVER, 0, 4e-3, 520e-6);
        add("contact solver DIRECT", Line.SOLVER, 0, 5e-5, 1900e-6);
        add("correction NONE", Line.CORRECTION, 0, Double.NaN, 450e-6);
        add("correction SOFT", Line.CORRECTION, 0, 3.9e-3, 505e-6);
        add("step, 1/60 s", Line.STEP, 1.0 / 60, 4e-3, 0);
        peers(new double[] {2e-2, 1.1e-2}, 900e-6);
    }

    private void presets(double[] errors, double cost) {
        String[] names = {"DRAFT", "GAME", "FINE", "EXACT"};
        for (int i = 0; i < names.length; i++) {
            add(names[i], Line.PRESETS, 0, errors[i], cost * Math.pow(2, 1.3 * i));
        }
    }

    private void steps(Line line, double error, double order, double cost) {
        for (int parts = 1; parts <= 32; parts *= 2) {
            double step = 1.0 / (30 * parts);
            String name = line.words() + ", 1/" + 30 * parts + " s";
            double reached = error * Math.pow(parts, -order);
            points.add(ours(new Setting(name, line, step, step), reached, cost * parts));
        }
    }

    private void sweep(Line line, double[] values, double error, double cost) {
        for (double value : values) {
            String name = line.words() + " " + (int) value;
            add(name, line, value, error / (value * value), cost * (0.4 + 0.6 * value));
        }
    }

    private void peers(double[] errors, double cost) {
        String[] names = {"dyn4j 6.0.0", "gdx-box2d 1.14.0", "jbox2d 2.2.1.1"};
        for (int i = 0; i < names.length; i++) {
            Setting usual = Setting.of("as it comes", Line.PEERS);
            Setting finer = new Setting("finer, 1/240 s", Line.PEERS, 0, 1.0 / 240);
            double more = 1 + 0.5 * i;
            points.add(point(problem, names[i], usual, errors[0] * more, cost * more));
            points.add(point(problem, names[i], finer, errors[1] * more, 3.8 * cost * more));
        }
    }

    private void add(String name, Line line, double at, double error, double cost) {
        points.add(ours(new Setting(name, line, at, Setting.USUAL_STEP), error, cost));
    }

    private Point ours(Setting setting, double error, double cost) {
        return point(problem, RigiBoEngine.NAME, setting, error, cost);
    }
}
