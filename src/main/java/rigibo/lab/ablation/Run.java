package rigibo.lab.ablation;

/**
 * One process that is to be run.
 *
 * @param workload the words that it is told
 * @param engine what it runs against
 * @param round which repetition, from 1
 * @param budget for how long
 */
record Run(String workload, Engine engine, int round, Budget budget) {

    /** The key under which the result is kept. */
    String name() {
        return String.join(" | ", workload, engine.name(), "" + round, budget.name());
    }

    /** The engine as it is, or without the classes of what a scene does not declare. */
    enum Engine {
        FULL,
        STRIPPED
    }

    /** How long a process warms up and is timed at least, ms. */
    enum Budget {
        /** For the ratio that has to be told to a percent. */
        LONG(1500, 1000),
        /** For costs that are read as such. */
        SHORT(400, 300);

        final int warmMillis;
        final int timedMillis;

        Budget(int warmMillis, int timedMillis) {
            this.warmMillis = warmMillis;
            this.timedMillis = timedMillis;
        }
    }
}
