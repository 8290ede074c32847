package rigibo.backend;

import rigibo.backend.team.RehearsedTeam;
import rigibo.backend.team.Team;
import rigibo.backend.team.ThreadTeam;

/** The team that shares a pool's steps. */
final class PoolWorkers {

    /** Null for one worker. */
    private Team team;

    private boolean areRehearsed;

    int count() {
        return team == null ? 1 : team.size();
    }

    /** Whether the team has this many workers and is, or is not, a rehearsal. */
    boolean are(int workers, boolean areRehearsed) {
        return count() == workers && (team == null || this.areRehearsed == areRehearsed);
    }

    /** Ends the present team and returns a team of this many workers; null for one worker. */
    Team hire(int workers) {
        ThreadTeam hired = workers == 1 ? null : new ThreadTeam(workers);
        if (hired != null) {
            hired.closeWith(this);
        }
        return replace(hired, false);
    }

    /**
     * Ends the present team and returns one without threads for a rehearsal; null for one worker.
     */
    Team rehearse(int workers) {
        return replace(workers == 1 ? null : new RehearsedTeam(workers, System::nanoTime), true);
    }

    private Team replace(Team next, boolean areRehearsed) {
        if (team != null) {
            team.close();
        }
        team = next;
        this.areRehearsed = areRehearsed;
        return team;
    }
}
