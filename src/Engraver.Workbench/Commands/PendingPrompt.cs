using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>A command that waits for an answer.</summary>
internal abstract class PendingPrompt(Prompt prompt)
{
    public Prompt Prompt => prompt;

    /// <summary>Passes an input to the waiting command.</summary>
    /// <returns>Null if it was accepted; otherwise which input is expected, and the command continues to wait.</returns>
    public abstract string? TryAnswer(string typed, Point2D lastPoint);

    /// <summary>Esc: the command ends at the prompt.</summary>
    public abstract void Cancel();
}
