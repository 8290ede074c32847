package rigibo.backend;

import rigibo.backend.team.Team;

/** The team that shares a pool's steps. */
final class PoolWorkers {

    /** Null for one worker. */
    private Team team;

    int count() {
        return team == null ? 1 : team.size();
    }

    /** Ends the present team, and returns one of a number of workers; null for one. */
    Team hire(int workers) {
        if (team != null) {
            team.close();
        }
        team = workers == 1 ? null : new Team(workers);
        if (team != null) {
            team.closeWith(this);
        }
        return team;
    }
}
