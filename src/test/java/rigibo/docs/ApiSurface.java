package rigibo.docs;

import rigibo.backend.Pool;

import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.lang.reflect.TypeVariable;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Everything that a caller of the engine can name: the public types of the packages that the module
 * exports, with their public members, as sorted lines of text. A line that goes or changes may
 * break a caller; a new line breaks nobody.
 */
public final class ApiSurface {

    private static final Pattern EXPORT = Pattern.compile("exports ([\\w.]+);");

    /** Members that every record and every enum has. */
    private static final List<String> GIVEN =
            List.of("equals", "hashCode", "toString", "values", "valueOf");

    private ApiSurface() {}

    /** The surface as one text. */
    public static String text(Path home) throws IOException, URISyntaxException {
        String declaration = Files.readString(home.resolve("src/engine/java/module-info.java"));
        Path classes =
                Path.of(Pool.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        StringBuilder text = new StringBuilder();
        List<String> exported =
                EXPORT.matcher(declaration).results().map(found -> found.group(1)).toList();
        for (String name : exported) {
            text.append("package ").append(name).append("\n\n");
            for (Class<?> type : typesOf(classes, name)) {
                text.append(String.join("\n", lines(type))).append("\n\n");
            }
        }
        return text.toString();
    }

    private static List<Class<?>> typesOf(Path classes, String packageName) throws IOException {
        List<Class<?>> types = new ArrayList<>();
        try (Stream<Path> files = Files.list(classes.resolve(packageName.replace('.', '/')))) {
            List<String> names =
                    files.map(file -> file.getFileName().toString())
                            .filter(name -> name.endsWith(".class") && !name.contains("-"))
                            .map(name -> name.substring(0, name.length() - ".class".length()))
                            .sorted()
                            .toList();
            for (String name : names) {
                Class<?> type = load(packageName + "." + name);
                if (isVisible(type)) {
                    types.add(type);
                }
            }
        }
        return types;
    }

    private static Class<?> load(String name) {
        try {
            return Class.forName(name, false, ApiSurface.class.getClassLoader());
        } catch (ClassNotFoundException missing) {
            throw new IllegalStateException(missing);
        }
    }

    private static boolean isVisible(Class<?> type) {
        Class<?> outer = type.getDeclaringClass();
        return Modifier.isPublic(type.getModifiers())
                && !type.isAnonymousClass()
                && (outer == null || isVisible(outer));
    }

    /** A type's own line, then its members. */
    private static List<String> lines(Class<?> type) {
        List<String> members = new ArrayList<>();
        for (Field field : type.getDeclaredFields()) {
            if (Modifier.isPublic(field.getModifiers())) {
                members.add(
                        modifiers(field.getModifiers())
                                + plain(field.getGenericType())
                                + " "
                                + field.getName());
            }
        }
        for (Constructor<?> constructor : type.getDeclaredConstructors()) {
            if (isShown(constructor) && !isCanonical(type, constructor)) {
                members.add(type.getSimpleName() + parameters(constructor));
            }
        }
        for (Method method : type.getDeclaredMethods()) {
            if (isShown(method) && !method.isBridge() && !isGiven(type, method)) {
                members.add(
                        modifiers(method.getModifiers())
                                + variables(method.getTypeParameters())
                                + plain(method.getGenericReturnType())
                                + " "
                                + method.getName()
                                + parameters(method));
            }
        }
        List<String> lines = new ArrayList<>(List.of(header(type)));
        members.stream().sorted().map(member -> "    " + member).forEach(lines::add);
        return lines;
    }

    private static boolean isShown(Executable member) {
        return Modifier.isPublic(member.getModifiers()) && !member.isSynthetic();
    }

    /** The constructor that the record's own line states. */
    private static boolean isCanonical(Class<?> type, Constructor<?> constructor) {
        return type.isRecord()
                && Arrays.equals(
                        constructor.getParameterTypes(),
                        Arrays.stream(type.getRecordComponents())
                                .map(RecordComponent::getType)
                                .toArray());
    }

    private static boolean isGiven(Class<?> type, Method method) {
        boolean isComponent =
                type.isRecord()
                        && Arrays.stream(type.getRecordComponents())
                                .anyMatch(component -> component.getAccessor().equals(method));
        boolean isOfAll = type.isRecord() || type.isEnum();
        return isComponent || isOfAll && GIVEN.contains(method.getName());
    }

    private static String header(Class<?> type) {
        String kind =
                type.isRecord()
                        ? "record "
                        : type.isEnum() ? "enum " : type.isInterface() ? "interface " : "class ";
        boolean isPlain = type.isRecord() || type.isEnum() || type.isInterface();
        String how = isPlain ? "" : modifiers(type.getModifiers());
        String name = plain(type);
        String components =
                type.isRecord()
                        ? Arrays.stream(type.getRecordComponents())
                                .map(part -> plain(part.getGenericType()) + " " + part.getName())
                                .collect(Collectors.joining(", ", "(", ")"))
                        : "";
        String faces =
                Arrays.stream(type.getGenericInterfaces())
                        .map(ApiSurface::plain)
                        .collect(Collectors.joining(", "));
        String permitted =
                type.isSealed()
                        ? Arrays.stream(type.getPermittedSubclasses())
                                .map(ApiSurface::plain)
                                .sorted()
                                .collect(Collectors.joining(", ", " permits ", ""))
                        : "";
        String is = type.isInterface() ? " extends " : " implements ";
        return (type.isSealed() ? "sealed " : "")
                + how
                + kind
                + name
                + variables(type.getTypeParameters())
                + components
                + (faces.isEmpty() ? "" : is + faces)
                + permitted;
    }

    private static String modifiers(int bits) {
        int told = bits & (Modifier.STATIC | Modifier.FINAL | Modifier.ABSTRACT);
        return told == 0 ? "" : Modifier.toString(told) + " ";
    }

    private static String variables(TypeVariable<?>[] variables) {
        return variables.length == 0
                ? ""
                : Arrays.stream(variables)
                        .map(each -> each + " extends " + plain(each.getBounds()[0]))
                        .collect(Collectors.joining(", ", "<", "> "));
    }

    private static String parameters(Executable member) {
        return Arrays.stream(member.getGenericParameterTypes())
                .map(ApiSurface::plain)
                .collect(Collectors.joining(", ", "(", ")"));
    }

    /** A type without the names of packages. */
    private static String plain(Type type) {
        return Pattern.compile("([a-z]\\w*\\.)+(?=[A-Z])|\\$")
                .matcher(type.getTypeName())
                .replaceAll((MatchResult found) -> found.group().equals("$") ? "." : "");
    }
}
