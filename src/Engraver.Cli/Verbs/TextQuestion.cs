using Engraver.Core.Drawings;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Cli.Verbs;

/// <summary>Asks on an interactive terminal whether texts that would not be cut are engraved.</summary>
internal static class TextQuestion
{
    /// <returns>True if they are to be engraved.</returns>
    public static async Task<bool> AskAsync(VerbHost host, Drawing drawing, DrawingSettings settings, CancellationToken stop)
    {
        if (!host.Interactive || UncutTexts.Count(drawing, settings) is not (> 0 and var texts)) return false;
        await host.Error.WriteAsync(Wording.Count("Run.EngraveTexts", texts) + " ").ConfigureAwait(false);
        await host.Error.FlushAsync(stop).ConfigureAwait(false);
        var answer = await host.ReadLineAsync(stop).ConfigureAwait(false);
        return answer?.Trim() is { Length: > 0 } typed && Wording.Get("Run.Yes").StartsWith(typed, StringComparison.OrdinalIgnoreCase);
    }
}
