/** Tests of whether an island rests: whether the forces it carries hold every body in place. */
package rigibo.backend.contact.hold;
