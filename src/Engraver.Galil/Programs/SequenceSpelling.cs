namespace Engraver.Galil.Programs;

/// <summary>Where two ways of writing vector sequences differ.</summary>
/// <param name="Open">Statements before VM; may be empty.</param>
/// <param name="AwaitEnd">The statement that waits for the end of the sequence.</param>
/// <param name="Rapid">The line that travels to a place in the controller's coordinates, tool off, and waits.</param>
/// <param name="ToolOn">Tool on and its settle; empty for a dry run.</param>
internal sealed record SequenceSpelling(string Open, string AwaitEnd, Func<CountsPoint, string> Rapid, IReadOnlyList<string> ToolOn);
