package rigibo.peers.dyn4j;

import org.dyn4j.collision.Filter;

/**
 * Prevents collisions between members of a group.
 *
 * @param group 0 for none
 */
record GroupFilter(int group) implements Filter {

    @Override
    public boolean isAllowed(Filter other) {
        return group == 0 || !equals(other);
    }

    @Override
    public Filter copy() {
        return this;
    }
}
