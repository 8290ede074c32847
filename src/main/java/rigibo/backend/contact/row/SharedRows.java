package rigibo.backend.contact.row;

import rigibo.backend.team.Team;

/**
 * Shares the contacts of a large island among the workers of a team. Passes take them colour by
 * colour: contacts of one colour have no moving body in common, so that no bit depends on which
 * worker solves which of them, nor on their order.
 */
public final class SharedRows {

    /** Contacts of an island from which on they are shared. */
    public static final int WORTHWHILE = 512;

    /** Fewest contacts in a piece of a pass; asking whether one is due takes some 5 ns. */
    private static final int GRAIN = 64;

    /** Null for one worker. */
    private final Team team;

    private final PackedContacts contacts;
    private final Team.Pieces shifted = this::shift;

    /** The work on the contacts of the present colour, and the first of them. */
    private Team.Pieces each;

    private int first;

    /** Shares packed contacts among a team; null for one worker. */
    public SharedRows(Team team, PackedContacts contacts) {
        this.team = team;
        this.contacts = contacts;
    }

    /** Number of workers. */
    public int workers() {
        return team == null ? 1 : team.size();
    }

    /** Whether there are several workers, and enough contacts in the packed island for them. */
    public boolean areWorthwhile() {
        return team != null && contacts.count >= WORTHWHILE;
    }

    /** Does something with the first contacts, each for itself. */
    public void each(int count, Team.Pieces each) {
        if (areWorthwhile()) {
            team.split(count, grain(count), each);
        } else {
            each.run(0, count, 0);
        }
    }

    /**
     * Does something with all contacts, in the order of colours or back; those with immovable
     * bodies come last in either direction. To be called where it is worthwhile.
     */
    public void pass(boolean isBack, Team.Pieces each) {
        this.each = each;
        int ground = contacts.groundColour;
        for (int i = 0; i < contacts.colours; i++) {
            int colour = isBack && i < ground ? ground - 1 - i : i;
            first = colour == 0 ? 0 : contacts.colourEnd[colour - 1];
            int count = contacts.colourEnd[colour] - first;
            if (count < 2 * GRAIN) {
                each.run(first, first + count, 0);
            } else {
                team.split(count, grain(count), shifted);
            }
        }
    }

    /** One piece for each worker: smaller ones would wander from cache to cache. */
    private int grain(int count) {
        return Math.max(GRAIN, count / team.size() + 1);
    }

    private void shift(int from, int to, int worker) {
        each.run(first + from, first + to, worker);
    }
}
