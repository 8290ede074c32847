package rigibo.backend.setup;

/**
 * Which shapes meet. Two do unless they are of the same group other than 0, or the mask of either
 * leaves out every category of the other.
 *
 * <pre>{@code
 * int player = 1 << 1;
 * int enemy = 1 << 2;
 * Filter shot = Filter.ALL.category(player).mask(~player); // passes through whoever fired it
 * pool.add(BodyDefinition.dynamic(new Circle(0.02)).filter(shot));
 * }</pre>
 *
 * @param category one bit for each of the up to 32 categories that the shape is of
 * @param mask one bit for each category that it meets; 0 meets nothing
 * @param group a number that all who never meet each other share, 0 for none
 */
public record Filter(int category, int mask, int group) {

    /** Of the first category, and meets all. */
    public static final Filter ALL = new Filter(1, ~0, 0);

    /** The same of other categories, one bit for each. */
    public Filter category(int bits) {
        return new Filter(bits, mask, group);
    }

    /** The same that meets other categories, one bit for each. */
    public Filter mask(int bits) {
        return new Filter(category, bits, group);
    }

    /** The same in another group, 0 for none. */
    public Filter group(int number) {
        return new Filter(category, mask, number);
    }

    /** Whether two shapes meet, as far as their filters say. */
    public boolean meets(Filter other) {
        return (group == 0 || group != other.group)
                && (category & other.mask) != 0
                && (other.category & mask) != 0;
    }

    /** Whether categories and mask leave out nobody of the first category. */
    public boolean isPlain() {
        return category == ALL.category && mask == ALL.mask;
    }
}
