using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCOVERRIDE: Changes feed or rapid speed of the running job and of the following ones, in percent of the plan.</summary>
internal sealed class CncOverrideCommand : ICommand
{
    private const double Percent = 100.0;

    public CommandInfo Info { get; } = new("CNCOVERRIDE", CommandGroup.Machine) { IsTransparent = true, IsAllowedDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var status = context.Machine.Status;
        var (slowest, fastest) = (JobControl.FeedRange.Min * Percent, JobControl.FeedRange.Max * Percent);
        var feed = await AskAsync(context, Wording.Get("CncOverride.EnterFeed", slowest, fastest), status.FeedRatio, JobControl.FeedRange, Keyword.List("Rapid")).ConfigureAwait(false);
        var rapid = default(double?);
        (slowest, fastest) = (JobControl.RapidRange.Min * Percent, JobControl.RapidRange.Max * Percent);
        if (feed is null) rapid = await AskAsync(context, Wording.Get("CncOverride.EnterRapid", slowest, fastest), status.RapidRatio, JobControl.RapidRange, []).ConfigureAwait(false);
        var set = context.Machine.Controls.Override(feed, rapid);
        context.WriteMessage(Wording.Get("CncOverride.Set", set.Feed * Percent, set.Rapid * Percent), MessageKind.Result);
    }

    /// <returns>The factor; null if the keyword was chosen.</returns>
    private static async Task<double?> AskAsync(CommandContext context, string instruction, double now, SpeedRange range, IReadOnlyList<Keyword> options)
    {
        var prompt = new NumberPrompt(instruction)
        {
            Options = options,
            Default = (now * Percent).ToString("0.##", CultureInfo.InvariantCulture),
            Min = range.Min * Percent,
            Max = range.Max * Percent,
        };
        var answer = await context.AskAsync(prompt).ConfigureAwait(false);
        return answer is Answer<double>.Value { Result: var percent } ? percent / Percent : null;
    }
}
