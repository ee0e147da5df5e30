namespace Engraver.Workbench.Stages;

/// <summary>Executes <see cref="JobStages.All"/>, as far as the caller needs it. Progress is reported before a stage, cancellation is checked between
/// stages.</summary>
/// <param name="job">The drawing and its settings, or a later state: the run continues with the stage behind the last one that returns it.</param>
/// <param name="cancellation">Ends the run with an <see cref="OperationCanceledException"/>.</param>
/// <param name="progress">Receives each stage that starts a step.</param>
public sealed class StageRun(DrawnJob job, CancellationToken cancellation, IProgress<JobStage>? progress = null)
{
    private DrawnJob _job = job;
    private int _done = job.GetType() == typeof(DrawnJob) ? 0 : JobStages.CountTo(job.GetType());

    /// <summary>Runs every stage up to the last one that returns <typeparamref name="T"/>, except those that have already been run.</summary>
    /// <exception cref="Settings.SettingException">A named layer or the entry entity is not in the drawing.</exception>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public T To<T>()
        where T : DrawnJob
    {
        for (var count = JobStages.CountTo(typeof(T)); _done < count; _done++)
        {
            cancellation.ThrowIfCancellationRequested();
            var stage = JobStages.All[_done];
            if (stage.StartsStep) progress?.Report(stage);
            _job = stage.Run(_job, cancellation);
        }

        return (T)_job;
    }
}
