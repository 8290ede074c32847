package rigibo.backend.setup;

/**
 * A collision filter. Two shapes collide unless both are in the same group other than 0, or the
 * mask of one contains no category of the other.
 *
 * <pre>{@code
 * int player = 1 << 1;
 * int enemy = 1 << 2;
 * Filter shot = Filter.ALL.category(player).mask(~player); // passes through whoever fired it
 * pool.add(BodyDefinition.dynamic(new Circle(0.02)).filter(shot));
 * }</pre>
 *
 * @param category bits of the categories that the shape belongs to, out of 32
 * @param mask bits of the categories that it collides with; 0 for none
 * @param group shapes with the same group never collide with each other; 0 for no group
 */
public record Filter(int category, int mask, int group) {

    /** In the first category, collides with all, in no group. */
    public static final Filter ALL = new Filter(1, ~0, 0);

    /** A copy with other categories, one bit for each. */
    public Filter category(int bits) {
        return new Filter(bits, mask, group);
    }

    /** A copy that collides with other categories, one bit for each. */
    public Filter mask(int bits) {
        return new Filter(category, bits, group);
    }

    /** A copy in another group; 0 for none. */
    public Filter group(int number) {
        return new Filter(category, mask, number);
    }

    /** Whether the filters of two shapes let them collide. */
    public boolean meets(Filter other) {
        return (group == 0 || group != other.group)
                && (category & other.mask) != 0
                && (other.category & mask) != 0;
    }

    /** Whether category and mask are those of {@link #ALL}. */
    public boolean isPlain() {
        return category == ALL.category && mask == ALL.mask;
    }
}
