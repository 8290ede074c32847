/** Whether an island rests: whether what it carries holds every body where it is. */
package rigibo.backend.contact.hold;
