using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The change of the tool, or the stop between repeats, at which a job has ended.</summary>
/// <param name="Ended">The section that is complete.</param>
/// <param name="Next">The section that is cut when the job continues.</param>
public sealed record SectionBreak(JobSection Ended, ToolSection Next)
{
    /// <summary>The tool is changed; otherwise it remains.</summary>
    public bool IsToolChange => Next.Repeat is null;

    /// <summary>The height of the work was set since the section ended. It is that of the tool before where the tool was changed and this is false.</summary>
    public bool IsHeightSet { get; init; }

    /// <summary>The height of the work has to be set with the next tool.</summary>
    public bool NeedsHeight(MachineProfile machine)
    {
        ArgumentNullException.ThrowIfNull(machine);
        return IsToolChange && !IsHeightSet && machine.Axes.Z is not null;
    }

    /// <summary>What follows: the name and the number of the tool, or the repeat and its operation.</summary>
    public string NextText => Next.Repeat is { } repeat ? Wording.Get("SectionBreak.Repeat", repeat, Next.Operations[0].Repeats, Next.Operations[0].Title) : Next.Tool.Title;

    /// <summary>The break after a run; null for a run that did not end at one.</summary>
    /// <param name="job">The whole job.</param>
    public static SectionBreak? Of(PreparedJob job, MachineRunReport ended)
    {
        ArgumentNullException.ThrowIfNull(ended);
        return ended.Result.Outcome.IsSectionEnd() && ended.Section is { IsLast: false } section ? new SectionBreak(section, section.Next(job)) : null;
    }
}
