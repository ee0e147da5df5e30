using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>A command that waits for an answer.</summary>
internal abstract class PendingAsk(Prompt prompt)
{
    public Prompt Prompt => prompt;

    /// <summary>Hands an input to the waiting command.</summary>
    /// <returns>Null when it was an answer; otherwise what is wanted instead, and the command goes on waiting.</returns>
    public abstract string? TryAnswer(string typed, Point2D lastPoint);

    /// <summary>Esc: the command ends where it waits.</summary>
    public abstract void Cancel();
}
