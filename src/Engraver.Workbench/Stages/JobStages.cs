namespace Engraver.Workbench.Stages;

/// <summary>The stages from a drawing to its motion, in the order of execution. A new stage is a line here.</summary>
public static class JobStages
{
    public static IReadOnlyList<JobStage> All { get; } =
    [
        new LetterStage(),
        new TableStage(),
        new AssignStage(),
        new KerfStage(),
        new ShapeStage(),
        new ChainStage(),
        new OrderStage(TimeProvider.System),
        new DressStage(),
        new PathStage(),
        new MotionStage(),
        new CheckStage(),
        new InspectStage(),
        new ProgramStage(),
    ];

    /// <summary>The stages up to the last one that returns <typeparamref name="T"/>.</summary>
    /// <exception cref="ArgumentException">No stage returns it.</exception>
    public static IEnumerable<JobStage> To<T>()
        where T : DrawnJob => All.Take(CountTo(typeof(T)));

    internal static int CountTo(Type state)
    {
        for (var i = All.Count; i > 0; i--)
        {
            if (All[i - 1].Output == state) return i;
        }

        throw new ArgumentException($"No stage returns {state.Name}.", nameof(state));
    }

    internal static double FractionBefore(JobStage stage) => All.TakeWhile(one => one != stage).Sum(one => one.Share) / All.Sum(one => one.Share);
}
