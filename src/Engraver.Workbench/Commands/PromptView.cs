using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>What the command window shows before the cursor.</summary>
/// <param name="Command">Name of the command that asks; null when a command is awaited.</param>
/// <param name="Text">The whole line, <c>&gt;&gt;</c> before it inside a transparent command.</param>
/// <param name="Options">To be clicked or completed.</param>
/// <param name="Default">What Enter alone means; null when nothing.</param>
/// <param name="TakesSpaces">True when Space is a letter and not Enter.</param>
/// <param name="Aim">The place that a click on the canvas answers with (its coordinates are fed); null when it is no answer.</param>
public sealed record PromptView(string? Command, string Text, IReadOnlyList<Keyword> Options, string? Default, bool TakesSpaces, PointAim? Aim)
{
    public static PromptView Idle { get; } = new(null, "Command:", [], null, false, null);
}
