using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Plots;

/// <summary>The plotted motions: the plan, the run that is under way or was the last, and a stored run for comparison.</summary>
/// <remarks>Any thread.</remarks>
public sealed class PlotSession(DerivationSession derivation, MachineSession machine)
{
    private readonly Lock _guard = new();
    private readonly Cached<PlannedMotion> _plan = new();
    private readonly Cached<RecordedRun> _run = new();
    private readonly Cached<RecordedRun> _comparedSeries = new();
    private (string Journal, RecordedRun Run)? _compared; // of the drawing that is open

    /// <summary>Raised after another stored run was chosen for comparison.</summary>
    public event EventHandler? Changed;

    /// <summary>The journal of the stored run for comparison; null for none.</summary>
    public string? ComparedJournal => Compared?.Journal;

    /// <summary>The stored run for comparison, unless another drawing is open now.</summary>
    private (string Journal, RecordedRun Run)? Compared
    {
        get
        {
            lock (_guard)
            {
                if (_compared is { } compared && !IsOfDrawing(compared.Run)) _compared = null;
                return _compared;
            }
        }
    }

    /// <summary>Sets the stored run for comparison.</summary>
    /// <param name="journal">Its journal.</param>
    public void Compare(string journal, RecordedRun run)
    {
        lock (_guard) _compared = (journal, run);
        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Removes the run for comparison.</summary>
    public void CompareNothing()
    {
        lock (_guard) _compared = null;
        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Releases the samples of all motions; they are computed again when the content is next requested.</summary>
    public void Forget()
    {
        _plan.Forget();
        _run.Forget();
        _comparedSeries.Forget();
    }

    /// <summary>True if the plan has changed since the last call of <see cref="Content"/>, and its samples must be computed.</summary>
    public bool IsPlanNew => derivation.Current is var current && !_plan.IsOf(current.Motion, current.Line);

    /// <summary>Content of the plots. Series are computed when their motion has changed.</summary>
    public PlotContent Content(DesktopSettings settings, CancellationToken cancellation)
    {
        var (current, compared) = (derivation.Current, Compared);
        var recorded = machine.Runs.Recorded is { } last && IsOfDrawing(last) ? last : null;
        var series = new List<PlotSeries>();
        if (_plan.Of(current.Motion, current.Line, Sampled, cancellation) is { Count: > 0 } plan) series.Add(new PlotSeries(PlotRole.Plan, "", plan));
        if (_run.Of(recorded, null, TraceSeries.From, cancellation) is { Count: > 0 } run) series.Add(new PlotSeries(PlotRole.Run, "", run));
        if (_comparedSeries.Of(compared?.Run, null, TraceSeries.From, cancellation) is { Count: > 0 } other) series.Add(new PlotSeries(PlotRole.Compared, Path.GetFileNameWithoutExtension(compared!.Value.Journal), other));
        var limits = (current.Job ?? recorded?.Job) is { } job ? PlotLimit.Of(job) : [];
        return PlotContent.Create(settings.PlotAxis(), settings.ChosenPlots(), series, limits);

        MotionSeries Sampled(PlannedMotion motion) => PlannedSeries.From(motion, JobPlan.LinkLoad(motion.Timeline.Program, current.Line, current.Strategy), PlannedSeries.MaxSamples, cancellation);
    }

    /// <summary>The run cut the drawing of the plan, in the state in which it is open.</summary>
    private bool IsOfDrawing(RecordedRun run) => ReferenceEquals(run.Job.DocumentDrawing, derivation.Current.State.Drawing);

    /// <summary>The series of the last motion.</summary>
    private sealed class Cached<T>
        where T : class
    {
        private readonly Lock _guard = new();
        private T? _motion;
        private object? _context;
        private MotionSeries? _series;

        /// <param name="context">What else the series depends on.</param>
        public bool IsOf(T? motion, object? context)
        {
            lock (_guard) return ReferenceEquals(motion, _motion) && Equals(context, _context);
        }

        public void Forget()
        {
            lock (_guard) (_series, _motion, _context) = (null, null, null);
        }

        /// <remarks>Computes outside the lock: another thread that only asks does not wait.</remarks>
        public MotionSeries? Of(T? motion, object? context, Func<T, MotionSeries> compute, CancellationToken cancellation)
        {
            lock (_guard)
            {
                if (ReferenceEquals(motion, _motion) && Equals(context, _context)) return _series;
            }

            var series = motion is null ? null : compute(motion);
            cancellation.ThrowIfCancellationRequested();
            lock (_guard)
            {
                (_series, _motion, _context) = (series, motion, context);
                return series;
            }
        }
    }
}
