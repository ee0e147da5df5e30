using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>One stage of the preparation: a pure function from one immutable state of the job to the next. <see cref="JobStages.All"/> is executed,
/// measured (<c>bench</c>), shown as progress and written to docs/pipeline.md.</summary>
/// <param name="key">Permanent name; the stage's texts are <c>Stage.KEY.Work</c>, <c>Stage.KEY.Result</c>, <c>Stage.KEY.Progress</c>.</param>
/// <param name="share">Estimated time compared with the other stages, for the progress bar.</param>
public abstract class JobStage(string key, double share)
{
    public string Key { get; } = key;

    /// <summary>Estimated time compared with the other stages.</summary>
    public double Share { get; } = share;

    /// <summary>Estimated fraction of the work before this stage, 0 to 1.</summary>
    public double Before => JobStages.FractionBefore(this);

    /// <summary>The state it takes, and every state derived from it.</summary>
    public abstract Type Input { get; }

    /// <summary>The state it returns; equal to <see cref="Input"/> for a stage that replaces a value or adds findings.</summary>
    public abstract Type Output { get; }

    /// <summary>The settings that it reads. No other setting changes its result.</summary>
    public abstract IReadOnlyList<Setting> Settings { get; }

    /// <summary>False: the progress remains at the step of an earlier stage, and there is no text <c>Stage.KEY.Progress</c>.</summary>
    public virtual bool StartsStep => true;

    /// <summary>True: <c>bench</c> has a row for it.</summary>
    public virtual bool IsMeasured => true;

    /// <summary>Name of the step that the progress shows.</summary>
    public string Name => Wording.Get($"Stage.{Key}.Progress");

    /// <summary>What it does, in docs/pipeline.md and <c>bench</c>.</summary>
    public string Work => Wording.Get($"Stage.{Key}.Work");

    /// <summary>What it returns, with the unit, in docs/pipeline.md.</summary>
    public string Result => Wording.Get($"Stage.{Key}.Result");

    /// <param name="job">A state of the type <see cref="Input"/>.</param>
    /// <param name="cancellation">Checked within a stage only if it may take long.</param>
    public abstract DrawnJob Run(DrawnJob job, CancellationToken cancellation);

    /// <summary>The size of its result, for <c>bench</c>.</summary>
    /// <param name="job">A state of the type <see cref="Output"/>.</param>
    public abstract string Figure(DrawnJob job);
}

/// <summary>A stage with the types of its states.</summary>
internal abstract class JobStage<TIn, TOut>(string key, double share) : JobStage(key, share)
    where TIn : DrawnJob
    where TOut : DrawnJob
{
    public sealed override Type Input => typeof(TIn);

    public sealed override Type Output => typeof(TOut);

    public sealed override DrawnJob Run(DrawnJob job, CancellationToken cancellation) => Execute((TIn)job, cancellation);

    public sealed override string Figure(DrawnJob job) => SizeOf((TOut)job);

    protected abstract TOut Execute(TIn job, CancellationToken cancellation);

    protected virtual string SizeOf(TOut job) => "";
}
