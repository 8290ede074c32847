package rigibo.lab.child;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Collection;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;

/** The class files of this process, by path; they can be written to an archive. */
public final class ClassFiles {

    private final Map<String, byte[]> files;

    private ClassFiles(Map<String, byte[]> files) {
        this.files = files;
    }

    /** The class files in the package of a class and in the packages below it. */
    public static ClassFiles of(Class<?> member) {
        String room = member.getPackageName().replace('.', '/');
        try {
            URI place = member.getProtectionDomain().getCodeSource().getLocation().toURI();
            Path path = Path.of(place);
            if (Files.isDirectory(path)) {
                return new ClassFiles(read(path, room));
            }
            try (FileSystem archive = FileSystems.newFileSystem(path)) {
                return new ClassFiles(read(archive.getPath("/"), room));
            }
        } catch (IOException | URISyntaxException cause) {
            throw new IllegalStateException("the classes that run here cannot be read", cause);
        }
    }

    private static Map<String, byte[]> read(Path root, String room) throws IOException {
        Map<String, byte[]> found = new TreeMap<>();
        try (Stream<Path> paths = Files.walk(root.resolve(room))) {
            for (Path path : paths.filter(Files::isRegularFile).toList()) {
                String name = root.relativize(path).toString().replace('\\', '/');
                found.put(name, Files.readAllBytes(path));
            }
        }
        return found;
    }

    /** The paths, sorted. */
    public Collection<String> names() {
        return files.keySet();
    }

    /** These files and others. */
    public ClassFiles and(ClassFiles others) {
        Map<String, byte[]> more = new TreeMap<>(files);
        more.putAll(others.files);
        return new ClassFiles(more);
    }

    /** These files without some. */
    public ClassFiles without(List<String> names) {
        Map<String, byte[]> fewer = new TreeMap<>(files);
        fewer.keySet().removeAll(names);
        return new ClassFiles(fewer);
    }

    /** Writes an archive that a Java process can have on its class path. */
    public void write(Path archive) {
        try (OutputStream out = Files.newOutputStream(archive);
                JarOutputStream jar = new JarOutputStream(out)) {
            for (Map.Entry<String, byte[]> file : files.entrySet()) {
                JarEntry entry = new JarEntry(file.getKey());
                entry.setTime(0);
                jar.putNextEntry(entry);
                jar.write(file.getValue());
            }
        } catch (IOException cause) {
            throw new UncheckedIOException("cannot write " + archive, cause);
        }
    }

    /** A hash of the classes' bytes. */
    public String hash() {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            files.forEach(
                    (name, bytes) -> {
                        digest.update(name.getBytes(StandardCharsets.UTF_8));
                        digest.update(bytes);
                    });
            return HexFormat.of().formatHex(digest.digest(), 0, 6);
        } catch (NoSuchAlgorithmException missing) {
            throw new IllegalStateException("every Java has SHA-256", missing);
        }
    }
}
