package rigibo.lab.ablation;

/**
 * One process to run.
 *
 * @param workload its words
 * @param engine the engine that it runs against
 * @param round which repetition, from 1
 * @param budget its time
 */
record Run(String workload, Engine engine, int round, Budget budget) {

    /** The key under which the result is kept. */
    String name() {
        return String.join(" | ", workload, engine.name(), "" + round, budget.name());
    }

    /** The whole engine, or one without the classes of undeclared effects. */
    enum Engine {
        FULL,
        STRIPPED
    }

    /** The least times of warm-up and timing, ms. */
    enum Budget {
        /** For the ratio that must be precise to a percent. */
        LONG(1500, 1000),
        /** For costs, which need less precision. */
        SHORT(400, 300);

        final int warmMillis;
        final int timedMillis;

        Budget(int warmMillis, int timedMillis) {
            this.warmMillis = warmMillis;
            this.timedMillis = timedMillis;
        }
    }
}
