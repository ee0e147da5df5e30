using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>The prompt as shown in the command window.</summary>
/// <param name="Command">Name of the prompting command; null if a command name is expected.</param>
/// <param name="Text">The whole line, <c>&gt;&gt;</c> before it inside a transparent command.</param>
/// <param name="Options">Options for clicking and completion.</param>
/// <param name="Default">The value of Enter alone; null without a default.</param>
/// <param name="AllowsSpaces">True if Space is part of the input and not Enter.</param>
/// <param name="PointRequest">The requested point (a click on the canvas enters its coordinates); null if no point is requested.</param>
public sealed record PromptView(string? Command, string Text, IReadOnlyList<Keyword> Options, string? Default, bool AllowsSpaces, PointRequest? PointRequest)
{
    /// <summary>Preview of Enter alone (<see cref="CommandLanguage.Prompt.Preview"/>); null without a preview.</summary>
    public GhostFunction? Preview { get; init; }

    /// <summary>The command line begins with the default (<see cref="TextPrompt.EditsDefault"/>).</summary>
    public bool EditsDefault { get; init; }

    /// <summary>Preview for a typed line that is not yet entered (<see cref="TextPrompt.TypedGhost"/>); null without a preview.</summary>
    public Func<string, IReadOnlyList<Segment>>? TypedGhost { get; init; }

    /// <summary>The requested file; null if no file is requested.</summary>
    public FileRequest? FileRequest { get; init; }

    /// <summary>True for the question whether a file is replaced.</summary>
    public bool ConfirmsReplacing { get; init; }

    public static PromptView Idle => new(null, Wording.Get("Prompt.Command"), [], null, false, null);
}
