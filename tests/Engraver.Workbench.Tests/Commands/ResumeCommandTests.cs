using Engraver.Core.Machines;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCRESUME without a held job: START cuts the rest of an interrupted job, or the contours from one on.</summary>
public class ResumeCommandTests
{
    [Theory]
    [InlineData("Stream")]
    [InlineData("Calls")]
    [InlineData("Program")]
    public async Task What_a_stopped_job_has_left_is_chosen_armed_and_cut(string mode)
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "CNCCONNECT", "sim:", "CNCRUN");
        if (mode != "Stream") await talk.TypeAsync(mode);
        StopAt(talk, progress => progress.SegmentsExecuted > 5);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("Yes"));
        Assert.Equal(JobOutcome.Stopped, talk.Session.Machine.Runs.LastRun!.Result.Outcome);

        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCRESUME"));
        Assert.Equal(talk.Session.Machine.Runs.LastRun.Journal, talk.Session.Prompt.Default);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(""));
        Assert.InRange(talk.Session.Machine.Runs.Part!.Shown.Segments, 5, 40);
        Assert.Equal(mode, talk.Session.Machine.Runs.Part.Strategy!.Keyword);
        await talk.TypeAsync("CNCARM", "");
        Assert.NotNull(talk.Session.Machine.Arming.Armed);
        Assert.Contains("segments are treated as already cut", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));

        var run = talk.Session.Machine.Runs.LastRun!;
        Assert.Equal((JobOutcome.Complete, 0.0), (run.Result.Outcome, run.Judgement.MissingLengthMm));
        Assert.NotNull(run.ResumedFrom);
        Assert.Null(talk.Session.Machine.Runs.Part); // it is cut
    }

    [Fact]
    public async Task The_contours_from_one_on_are_cut_and_no_other()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "CNCCONNECT", "sim:", "CNCRESUME", "Contour", "2");
        var before = talk.Session.Machine.Runs.Part!.Shown.Segments;
        Assert.InRange(before, 1, 40);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Yes"));

        var executed = talk.Session.Machine.Runs.LastRun!.Result.ExecutedByStroke;
        Assert.Equal(JobOutcome.Complete, talk.Session.Machine.Runs.LastRun.Result.Outcome);
        Assert.Equal(before, executed[0]);
        Assert.True(talk.Session.Machine.Runs.LastRun.Result.SegmentsSent < executed.Sum());
    }

    [Fact]
    public async Task A_part_ends_with_the_drawing_it_was_chosen_for_or_when_it_is_taken_back()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "CNCCONNECT", "sim:", "CNCRESUME", "Contour", "2", "CNCARM", "Stream");
        Assert.NotNull(talk.Session.Machine.Arming.Armed);
        await talk.TypeAsync("CNCRESUME", "Whole");
        Assert.Null(talk.Session.Machine.Runs.Part);
        Assert.Null(talk.Session.Machine.Arming.Armed);
        await talk.TypeAsync("CNCRESUME", "Contour", "2", "REVERSE", "ALL", "");

        Assert.Null(talk.Session.Machine.Runs.Part);
    }

    [Theory]
    [InlineData("CNCORIGIN", "G55")]
    [InlineData("CNCZERO", "All")]
    public async Task A_part_ends_with_the_work_origin_it_was_chosen_at_and_it_is_said(params string[] change)
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "CNCCONNECT", "sim:", "CNCRESUME", "Contour", "2");
        Assert.NotNull(talk.Session.Machine.Runs.Part);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync(change));

        Assert.Null(talk.Session.Machine.Runs.Part);
        Assert.Contains("START cuts the whole drawing.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_lead_in_is_an_option_and_is_kept_for_the_session()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "CNCCONNECT", "sim:");
        await StopInTheMiddleAsync(talk);

        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("CNCRESUME", "Leadin", "1001"));
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("2.5"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(""));
        Assert.Equal(2.5, talk.Session.Machine.Runs.Part!.Request.LeadInMm);
        await talk.TypeAsync("CNCRESUME", "Whole", "CNCRESUME", "");

        Assert.Equal(2.5, talk.Session.Machine.Runs.Part!.Request.LeadInMm);
    }

    /// <summary>Two plates in two fixtures: the rest of the first is not cut in the fixture of the second.</summary>
    [Fact]
    public async Task What_was_begun_at_one_origin_is_not_cut_at_another()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "CNCCONNECT", "sim:", "CNCZERO", "All");
        await StopInTheMiddleAsync(talk);
        var journal = talk.Session.Machine.Runs.LastRun!.Journal!;
        await talk.TypeAsync("CNCORIGIN", "G55", "CNCGOTO", "80,40", "CNCZERO", "All", "CNCRESUME", journal, "CNCARM", "Stream");
        var there = talk.Session.Machine.Status.MachinePosition;

        var refused = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN"));

        Assert.Contains("Not started", refused.Message, StringComparison.Ordinal);
        Assert.Contains("started with the drawing zero at 0,0 mm, but work origin G55 is now at 80,40 mm", talk.Said, StringComparison.Ordinal);
        Assert.Equal(there, talk.Session.Machine.Status.MachinePosition);
        await talk.TypeAsync("CNCRESUME", "Origin", journal, "CNCARM", "Stream");
        Assert.True(talk.Session.Machine.Runs.Part!.Request.AtOrigin);
        await talk.TypeAsync("CNCORIGIN", "G54", "CNCRESUME", journal, "CNCARM", "Stream");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));
        Assert.Equal((JobOutcome.Complete, 0.0), (talk.Session.Machine.Runs.LastRun!.Result.Outcome, talk.Session.Machine.Runs.LastRun.Judgement.MissingLengthMm));
    }

    [Fact]
    public async Task A_journal_that_does_not_fit_chooses_nothing()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "CNCCONNECT", "sim:");
        var refused = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRESUME", "no such journal"));

        Assert.Contains("cannot be read", refused.Message, StringComparison.Ordinal);
        Assert.Null(talk.Session.Machine.Runs.Part);
    }

    private static async Task StopInTheMiddleAsync(CommandTestSession talk)
    {
        StopAt(talk, progress => progress.SegmentsExecuted > 5);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN", "Yes"));
        Assert.Equal(JobOutcome.Stopped, talk.Session.Machine.Runs.LastRun!.Result.Outcome);
    }

    /// <summary>Once, and only in the first job.</summary>
    private static void StopAt(CommandTestSession talk, Func<JobProgress, bool> when)
    {
        var stopped = false;
        talk.Session.Machine.Changed += (_, _) =>
        {
            if (stopped || talk.Session.Machine is not { IsRunning: true, Runs.Progress: { } progress } || !when(progress)) return;
            stopped = true;
            talk.Session.Machine.Controls.Stop();
        };
    }
}
