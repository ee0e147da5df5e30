namespace Engraver.Simulator.Language;

internal enum StatementKind
{
    /// <summary>Nothing to do: blank, or a comment behind an apostrophe.</summary>
    Nothing,
    Command,
    Assignment,
    Unknown,
}
