using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>Commits a change of trajectories as one undo step.</summary>
internal static class TrajectoryChange
{
    public static void Settings(CommandContext context, Func<TrajectorySettings, TrajectorySettings> change)
    {
        var list = context.Document.Current.Sidecar.Trajectories;
        if (change(list.Settings) is var changed && changed != list.Settings) Commit(context, list with { Settings = changed });
    }

    public static void All(CommandContext context, IReadOnlyList<DocumentTrajectory> all) => All(context, all, context.Document.Current.Sidecar.Trajectories.NextNumber);

    /// <param name="next">Number in the name of the next trajectory.</param>
    public static void All(CommandContext context, IReadOnlyList<DocumentTrajectory> all, int next) => Commit(context, context.Document.Current.Sidecar.Trajectories with { All = all, NextNumber = next });

    private static void Commit(CommandContext context, TrajectoryList list)
    {
        var state = context.Document.Current;
        context.Commit(state with { Sidecar = state.Sidecar with { Trajectories = list } });
    }
}
