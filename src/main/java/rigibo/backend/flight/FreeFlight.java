package rigibo.backend.flight;

import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

/** Moves the bodies in flight along their paths, without impacts. */
public final class FreeFlight {

    final Trajectories paths;

    private final Roster roster;

    /** Paths under forces that vary along the path; null if there are none. */
    private final Course course;

    /** Free flight; {@code course} is null where no path has to be integrated. */
    public FreeFlight(DataStorage data, Course course) {
        roster = data.roster;
        this.course = course;
        paths = new Trajectories(data.bodies);
    }

    /** Moves every flyer to the end of a step of {@code dt} seconds. */
    public void fly(double dt) {
        if (roster.awakeCount > 0) {
            paths.begin();
            finish(dt);
        }
    }

    /** Moves every flyer from its present time to the end of a step. */
    void finish(double dt) {
        paths.advanceAll(roster, dt);
        if (course != null) {
            catchUp(dt);
        }
    }

    private void catchUp(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            if (paths.isFlyer(roster.awake[i])) {
                course.catchUp(roster.awake[i], dt);
            }
        }
    }
}
