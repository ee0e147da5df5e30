using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Sequencing;

/// <summary>Animation of AUTOSEQUENCE: highlights the contours in their order, and asks at each discontinuity whether to continue (paper 000).</summary>
internal static class ContourAnimation
{
    private static readonly TimeSpan s_step = TimeSpan.FromMilliseconds(100);
    private static readonly TimeSpan s_maxDuration = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan s_minDuration = TimeSpan.FromMilliseconds(20);

    /// <param name="path">Of the same sequence.</param>
    /// <param name="asks">The operator is asked at each discontinuity.</param>
    /// <exception cref="OperationCanceledException">Esc.</exception>
    public static async Task RunAsync(CommandContext context, SequencingResult result, Toolpath path, bool asks, CancellationToken cancellation)
    {
        if (path.Strokes.Count == 0) return;
        var pause = s_maxDuration / path.Strokes.Count < s_step ? s_maxDuration / path.Strokes.Count : s_step;
        var (walked, due) = (0, TimeSpan.Zero);
        try
        {
            foreach (var stroke in path.Strokes)
            {
                walked += stroke.Moves.Count;
                context.SequenceAnimation.SetMoves(walked);
                due += pause;
                if (due >= s_minDuration)
                {
                    await Task.Delay(due, context.Time, cancellation).ConfigureAwait(false);
                    due = TimeSpan.Zero;
                }

                if (!asks || result.Strokes[stroke.Index].Closed || stroke.Index == path.Strokes.Count - 1 || Question(result, stroke) is not { } question) continue;
                var answer = await context.ChoiceAsync(question, Keyword.List("Yes", "No", "All"), "Yes").ConfigureAwait(false);
                if (answer == "No")
                {
                    context.WriteMessage(Wording.Get("AutoSequence.StoppedAfter", stroke.Index + 1, path.Strokes.Count));
                    return;
                }

                asks = answer != "All";
            }
        }
        finally
        {
            context.SequenceAnimation.End();
        }
    }

    /// <summary>Null for a stroke of a letter, whose end is not a discontinuity.</summary>
    private static string? Question(SequencingResult result, ToolpathStroke stroke)
    {
        var (ends, place, at) = (result.Discontinuities, result.Strokes[stroke.Index].End, 0);
        while (at < ends.Count && ends.PlaceOf(at) != place) at++;
        if (at == ends.Count) return null;
        return ends[at].Gap is { } away
            ? Wording.Get("AutoSequence.Discontinuity", stroke.Index + 1, stroke.End.X, stroke.End.Y, away)
            : Wording.Get("AutoSequence.LastDiscontinuity", stroke.Index + 1, stroke.End.X, stroke.End.Y);
    }
}
