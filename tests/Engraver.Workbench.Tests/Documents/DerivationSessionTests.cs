using Engraver.Core.Machines;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Documents;

public sealed class DerivationSessionTests : IDisposable
{
    private readonly DocumentSession _document = new();
    private readonly DerivationSession _derivation;

    public DerivationSessionTests()
    {
        _document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 10, 0).Circle(20, 5, 3).Build() });
        _derivation = new DerivationSession(_document, new PlateSession(CounterBook.In(Path.GetTempPath(), TimeProvider.System), TimeProvider.System));
    }

    [Fact]
    public async Task Everything_follows_from_the_document()
    {
        var derived = await _derivation.ForCurrentAsync(CancellationToken.None);

        Assert.Equal((2, 2), (derived.Analysed!.Count, derived.Sequence!.Contours));
        Assert.Equal(JobPlan.NetworkTimes(derived.Job!.Motion.Program!), derived.Plan);
        Assert.Equal(derived.Plan!.Value.Total, derived.Motion!.DurationSeconds, precision: 9);
        Assert.Equal(PostedProgram.Create(_document.Current.Drawing!, _document.Current.Settings, PostTable.Find("galil").Post, PostedProgram.NoOptions).Text, derived.Program!.Text);
        Assert.Contains(derived.Findings, found => found.Id == "SEQ0002");
        Assert.Same(derived, _derivation.Current);
        Assert.True(_derivation.IsCurrent);
    }

    /// <summary>A window shows a drawing before it plans it; a failed or missing picture does not block the plan.</summary>
    [Fact]
    public async Task Nothing_is_computed_before_what_is_waited_for_has_ended_however_it_ends()
    {
        var picture = new TaskCompletionSource();
        _derivation.Prerequisite = state => ReferenceEquals(state, _document.Current) ? picture.Task : throw new InvalidOperationException();
        var derived = _derivation.ForCurrentAsync(CancellationToken.None);
        Assert.Null(_derivation.Progress.Stage);
        Assert.False(derived.IsCompleted);
        picture.SetException(new TimeoutException());

        Assert.Equal(2, (await derived.WaitAsync(TimeSpan.FromSeconds(60))).Analysed!.Count);
        _derivation.Prerequisite = _ => new TaskCompletionSource().Task;
        _derivation.Line = new SerialAddress("/dev/ttyS0", 9600); // Of a known job only the plan is recomputed.
        Assert.NotNull((await _derivation.ForCurrentAsync(CancellationToken.None).WaitAsync(TimeSpan.FromSeconds(60))).Plan);
    }

    [Fact]
    public async Task What_waits_is_given_up_and_left_like_what_is_computed()
    {
        _derivation.Prerequisite = _ => new TaskCompletionSource().Task;
        var derived = _derivation.ForCurrentAsync(CancellationToken.None);
        Assert.True(_derivation.Cancel());
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => derived);
        Assert.True(_derivation.IsCancelled);
        _derivation.Prerequisite = null;
        Assert.Equal(2, (await _derivation.ForCurrentAsync(CancellationToken.None)).Analysed!.Count);
    }

    [Fact]
    public async Task A_search_for_the_order_is_ended_and_the_job_has_the_best_order_found()
    {
        var builder = new DrawingBuilder();
        for (var line = 0; line < 30; line++) builder.Line(line * 7 % 30 * 10, 0, (line * 7 % 30 * 10) + 3, 5);
        _document.Commit("OPEN", new DocumentState { Drawing = builder.Build(), Settings = new DrawingSettings { Order = StrokeOrder.Optimal, OrderSeconds = 86_400 } });
        Assert.False(_derivation.StopOrderSearch());
        var derived = _derivation.ForCurrentAsync(CancellationToken.None);
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        while (!_derivation.StopOrderSearch()) await Task.Run(limit.Token.ThrowIfCancellationRequested, CancellationToken.None);

        Assert.Equal(30, (await derived.WaitAsync(TimeSpan.FromSeconds(60))).Sequence!.Strokes.Count);
        Assert.False(_derivation.IsCancelled);
        Assert.True(_derivation.IsCurrent);
    }

    [Fact]
    public async Task The_same_state_is_computed_once_and_a_selection_is_no_other_state()
    {
        var first = await _derivation.ForCurrentAsync(CancellationToken.None);
        _document.Select([0], []);

        Assert.Same(first, await _derivation.ForCurrentAsync(CancellationToken.None));
        _document.Commit("X", _document.Current with { Settings = _document.Current.Settings with { MaxErrorMm = 0.01 } });
        Assert.False(_derivation.IsCurrent);
        Assert.NotSame(first, await _derivation.ForCurrentAsync(CancellationToken.None));
    }

    [Fact]
    public async Task Another_line_makes_another_plan_of_the_same_job()
    {
        var network = await _derivation.ForCurrentAsync(CancellationToken.None);
        _derivation.Line = new SerialAddress("/dev/ttyS0", 9600);
        Assert.False(_derivation.IsCurrent);
        var serial = await _derivation.ForCurrentAsync(CancellationToken.None);

        var fit = JobPlan.FitToLink(network.Job!.Motion.Program!, _derivation.Line, JobMode.Stream.Strategy(), network.Job.Drawing).Program;
        Assert.Equal(JobPlan.PlannedTimes(fit, _derivation.Line, JobMode.Stream.Strategy()), serial.Plan);
        Assert.True(serial.Plan!.Value.Total > network.Plan!.Value.Total);
        Assert.Same(network.Motion, serial.Motion);
        _derivation.Line = null;
        Assert.Equal(network.Plan, (await _derivation.ForCurrentAsync(CancellationToken.None)).Plan);
    }

    [Fact]
    public async Task Two_who_ask_at_once_get_the_same_work()
    {
        var both = await Task.WhenAll(_derivation.ForCurrentAsync(CancellationToken.None), _derivation.ForCurrentAsync(CancellationToken.None));

        Assert.Same(both[0], both[1]);
    }

    [Fact]
    public async Task What_is_out_of_date_before_it_is_done_is_given_up()
    {
        var drawing = Many(20_000);
        _document.Commit("OPEN", new DocumentState { Drawing = drawing });
        var old = _derivation.ForCurrentAsync(CancellationToken.None);
        _document.Commit("ERASE", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 1, 0).Build() });

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => old);
        Assert.Single((await _derivation.ForCurrentAsync(CancellationToken.None)).Sequence!.Strokes);
        Assert.Single(_derivation.Current.Sequence!.Strokes);
    }

    [Fact]
    public async Task Whoever_does_not_want_to_wait_any_more_does_not()
    {
        _document.Commit("OPEN", new DocumentState { Drawing = Many(20_000) });
        using var impatient = new CancellationTokenSource();
        var waiting = _derivation.ForCurrentAsync(impatient.Token);
        await impatient.CancelAsync();

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => waiting);
        Assert.Equal(20_000, (await _derivation.ForCurrentAsync(CancellationToken.None)).Analysed!.Count);
    }

    [Fact]
    public async Task A_setting_that_does_not_fit_is_a_sentence_and_no_exception()
    {
        _document.Commit("X", _document.Current with { Settings = new DrawingSettings { Layers = ["NOPE"] } });

        var derived = await _derivation.ForCurrentAsync(CancellationToken.None);

        Assert.Contains("NOPE", derived.Problem, StringComparison.Ordinal);
        Assert.Null(derived.Job);
    }

    [Fact]
    public async Task With_no_drawing_nothing_follows()
    {
        _document.Commit("CLOSE", DocumentState.Nothing);

        Assert.Null((await _derivation.ForCurrentAsync(CancellationToken.None)).Job);
    }

    [Fact]
    public async Task A_desktop_is_kept_up_to_date_without_asking()
    {
        var derived = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        _derivation.Changed += (_, _) => { if (_derivation.Current.Analysed?.Count == 1) derived.TrySetResult(); };
        _derivation.IsAutomatic = true;
        _document.Commit("ERASE", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 1, 0).Build() });
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        await derived.Task.WaitAsync(limit.Token);

        Assert.True(_derivation.IsCurrent);
    }

    public void Dispose() => _derivation.Dispose();

    private static Core.Drawings.Drawing Many(int count)
    {
        var builder = new DrawingBuilder();
        for (var i = 0; i < count; i++) builder.Line(i % 200, i / 200, (i % 200) + 0.5, i / 200);
        return builder.Build();
    }
}
