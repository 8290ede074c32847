package rigibo.lab.bench.workers;

import rigibo.backend.Pool;

/**
 * The workers that make the steps of a pool.
 *
 * @param workers their number
 * @param areRehearsed whether one thread does the work of all, and times are computed
 */
public record Crew(int workers, boolean areRehearsed) {

    void hireFor(Pool pool) {
        if (areRehearsed) {
            pool.rehearse(workers);
        } else {
            pool.workers(workers);
        }
    }

    /** As a table has it. */
    String words() {
        return workers + (areRehearsed ? ", computed" : "");
    }
}
