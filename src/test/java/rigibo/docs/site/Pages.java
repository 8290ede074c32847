package rigibo.docs.site;

import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Files of the checkout as pages, and whatever they link to. */
final class Pages {

    private final Path home;
    private final Path folder;
    private final Layout layout;
    private final Map<Path, Consumer<Node>> changes = new HashMap<>();
    private final Deque<Path> open = new ArrayDeque<>();
    private final Set<Path> known = new HashSet<>();

    /** From a checkout into a folder. */
    Pages(Path home, Path folder, Layout layout) {
        this.home = home;
        this.folder = folder;
        this.layout = layout;
    }

    /** Changes a page of Markdown before it is written. */
    void change(Path file, Consumer<Node> change) {
        changes.put(file, change);
    }

    /** Writes files, those that they link to, and so on. */
    void write(Collection<Path> files) throws IOException {
        files.forEach(this::want);
        while (!open.isEmpty()) {
            write(open.poll());
        }
    }

    private Path want(Path file) {
        if (known.add(file)) {
            open.add(file);
        }
        return Files.isDirectory(home.resolve(file))
                ? Address.ofFolder(file)
                : Address.ofFile(file);
    }

    private void write(Path file) throws IOException {
        Path source = home.resolve(file);
        if (Files.isDirectory(source)) {
            writeFolder(file);
        } else if (Address.isPicture(file)) {
            Path copy = folder.resolve(file);
            Files.createDirectories(copy.getParent());
            Files.copy(source, copy, StandardCopyOption.REPLACE_EXISTING);
        } else if (file.toString().endsWith(".md")) {
            writeMarkdown(file);
        } else {
            String code = Source.html(file.toString(), Files.readString(source));
            String name = file.getFileName().toString();
            layout.write(
                    Address.ofFile(file), name, "<h1>" + Html.escaped(name) + "</h1>\n" + code);
        }
    }

    private void writeMarkdown(Path file) throws IOException {
        Node document = Markdown.parse(Files.readString(home.resolve(file)));
        document.accept(new Links(file));
        changes.getOrDefault(file, unchanged -> {}).accept(document);
        layout.write(Address.ofFile(file), Markdown.title(document), Markdown.html(document));
    }

    /** A list of its files, each by its title. */
    private void writeFolder(Path file) throws IOException {
        Path page = Address.ofFolder(file);
        StringBuilder list = new StringBuilder();
        try (Stream<Path> files = Files.list(home.resolve(file))) {
            for (Path inside : files.filter(Pages::isShown).sorted().collect(Collectors.toList())) {
                String link = Address.link(page, want(home.relativize(inside)));
                list.append("<li>").append(Html.link(link, Html.escaped(title(inside))));
                list.append("</li>\n");
            }
        }
        String title = title(home.resolve(file));
        layout.write(
                page, title, "<h1>" + title + "</h1>\n<ul class=\"list\">\n" + list + "</ul>\n");
    }

    /** Pictures are shown where they belong. */
    private static boolean isShown(Path inside) {
        return !Address.isPicture(inside) && !inside.endsWith("pictures");
    }

    private static String title(Path file) throws IOException {
        String name = file.getFileName().toString();
        return name.endsWith(".md")
                ? Markdown.title(Markdown.parse(Files.readString(file)))
                : Files.isDirectory(file)
                        ? Character.toUpperCase(name.charAt(0)) + name.substring(1)
                        : name;
    }

    /** Leads links to the pages of what they name. */
    private final class Links extends AbstractVisitor {

        private final Path file;

        Links(Path file) {
            this.file = file;
        }

        @Override
        public void visit(Link link) {
            link.setDestination(changed(link.getDestination()));
            visitChildren(link);
        }

        @Override
        public void visit(Image image) {
            image.setDestination(changed(image.getDestination()));
            visitChildren(image);
        }

        private String changed(String destination) {
            if (destination.contains("://") || destination.startsWith("#")) {
                return destination;
            }
            int mark = destination.indexOf('#');
            String path = mark < 0 ? destination : destination.substring(0, mark);
            Path to = want(home.relativize(home.resolve(file).resolveSibling(path).normalize()));
            String anchor = mark < 0 ? "" : destination.substring(mark);
            return Address.link(Address.ofFile(file), to) + anchor;
        }
    }
}
