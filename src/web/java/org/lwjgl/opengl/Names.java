package org.lwjgl.opengl;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** Numbers for objects that WebGL knows by reference; 0 is none. */
final class Names<T> {

    private final List<T> objects = new ArrayList<>();
    private final Deque<Integer> free = new ArrayDeque<>();

    int add(T object) {
        if (free.isEmpty()) {
            objects.add(object);
            return objects.size();
        }
        int name = free.pop();
        objects.set(name - 1, object);
        return name;
    }

    T get(int name) {
        return name == 0 ? null : objects.get(name - 1);
    }

    T remove(int name) {
        if (name == 0) {
            return null;
        }
        free.push(name);
        return objects.set(name - 1, null);
    }
}
