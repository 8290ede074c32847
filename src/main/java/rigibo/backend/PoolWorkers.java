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

    /** Whether there are as many workers, with threads of their own or without. */
    boolean are(int workers, boolean areRehearsed) {
        return count() == workers && (team == null || this.areRehearsed == areRehearsed);
    }

    /** Ends the present team, and returns one of a number of workers; null for one. */
    Team hire(int workers) {
        ThreadTeam hired = workers == 1 ? null : new ThreadTeam(workers);
        if (hired != null) {
            hired.closeWith(this);
        }
        return replace(hired, false);
    }

    /** Ends the present team, and returns one without threads; null for one worker. */
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
