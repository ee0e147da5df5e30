namespace Engraver.Core.Posts;

/// <summary>One option of a post.</summary>
/// <param name="Name">Name without dashes.</param>
/// <param name="Argument">Placeholder of the value in a help text.</param>
/// <param name="Summary">Description in one sentence.</param>
/// <param name="Default">The value when none is given.</param>
/// <param name="Form">Form of a value: "a whole number from 1 to 9".</param>
/// <param name="IsValid">True for a valid value.</param>
public sealed record PostOption(string Name, string Argument, string Summary, string Default, string Form, Func<string, bool> IsValid);
