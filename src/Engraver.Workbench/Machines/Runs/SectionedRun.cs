using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Runs the sections of a job one after the other: each is a run with its own journal, which resumes the one before it.</summary>
public static class SectionedRun
{
    /// <param name="options">Of the first section; the files of later ones have its number in their names.</param>
    /// <param name="scale">Of the machine.</param>
    /// <param name="run">Runs the next section.</param>
    /// <param name="continues">Called after each section but the last, with its report and, where the next one could not be started, with that report;
    /// false ends the run.</param>
    /// <returns>The report of all sections that were run; that of the only section of a job that has no other.</returns>
    /// <exception cref="ControllerException">The link could not be established for the first section.</exception>
    public static async Task<MachineRunReport> RunAsync(MachineRunOptions options, CountsScale scale, Func<MachineRunOptions, Task<MachineRunReport>> run, Func<MachineRunReport, MachineRunReport?, Task<bool>> continues)
    {
        ArgumentNullException.ThrowIfNull(options);
        ArgumentNullException.ThrowIfNull(run);
        ArgumentNullException.ThrowIfNull(continues);
        var sections = new List<MachineRunReport> { await run(options).ConfigureAwait(false) };
        MachineRunReport? refused = null;
        while (sections[^1] is var ended && ended.Result.Outcome.IsSectionEnd() && await continues(ended, refused).ConfigureAwait(false))
        {
            var next = await OrLostAsync(run, After(options, ended, scale, sections.Count + 1), ended).ConfigureAwait(false);
            refused = next.Result is { Outcome: JobOutcome.Refused, FrameOrigin: null } ? next : null;
            if (refused is null) sections.Add(next);
        }

        return MachineRunReport.OfSections(sections);
    }

    /// <summary>A link that cannot be established between two sections ends the run as one that is lost.</summary>
    private static async Task<MachineRunReport> OrLostAsync(Func<MachineRunOptions, Task<MachineRunReport>> run, MachineRunOptions options, MachineRunReport before)
    {
        try
        {
            return await run(options).ConfigureAwait(false);
        }
        catch (ControllerException lost)
        {
            return before with
            {
                Result = before.Result with { Outcome = JobOutcome.LinkLost, Message = lost.Message, SegmentsSent = 0, Seconds = 0.0, Underruns = 0, Rejected = 0, Holds = 0, Diagnostics = [] },
                Judgement = before.Judgement with { MissingLengthMm = before.Judgement.MissingLengthMm is null ? null : 0.0, MissingAt = null },
                PlannedSeconds = 0.0,
            };
        }
    }

    /// <summary>The options of the section after the end of another one. The present position is no longer the drawing's zero.</summary>
    private static MachineRunOptions After(MachineRunOptions options, MachineRunReport ended, CountsScale scale, int run) => options with
    {
        JournalPath = JournalFolder.OfSection(options.JournalPath, run),
        TracePath = options.TracePath is { } trace ? JournalFolder.OfSection(trace, run) : null,
        Resume = new ResumeRequest { Journal = ended.Journal, LeadInMm = options.Resume?.LeadInMm ?? ResumeRequest.DefaultLeadInMm },
        Origin = options.Origin is OriginRequest.PresentPosition && ended.Placement is { Frame: { } frame } ? new OriginRequest.MachinePoint(scale.ToMillimetres(frame.X, frame.Y)) : options.Origin,
        Starting = null,
    };
}
