using Engraver.Core.Drawings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Stages;

namespace Engraver.Cli.Verbs;

/// <summary>Asks on an interactive terminal whether texts that would not be cut are engraved.</summary>
internal static class TextQuestion
{
    /// <returns>The settings that cut texts; null to leave the job as it is.</returns>
    public static async Task<Workbench.Settings.DrawingSettings?> AskAsync(VerbHost host, PreparedJob job, CancellationToken stop)
    {
        if (!host.Interactive || UncutTexts.Count(job.DocumentDrawing, job.Settings) is not (> 0 and var texts)) return null;
        await host.Error.WriteAsync(Wording.Count("Run.EngraveTexts", texts) + " ").ConfigureAwait(false);
        await host.Error.FlushAsync(stop).ConfigureAwait(false);
        var answer = await Task.Run(host.In.ReadLine, stop).WaitAsync(stop).ConfigureAwait(false); // A console read cannot be cancelled: the operator's stop does not wait for it.
        return answer?.Trim() is { Length: > 0 } typed && Wording.Get("Run.Yes").StartsWith(typed, StringComparison.OrdinalIgnoreCase) ? job.Settings with { Cut = job.Settings.Cut | CutChoice.Text } : null;
    }
}
