using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>Trajectories by name.</summary>
internal static class TrajectorySelection
{
    /// <exception cref="CommandException">There is none.</exception>
    public static IReadOnlyList<DocumentTrajectory> All(CommandContext context) =>
        context.Document.Current.Sidecar.Trajectories.All is { Count: > 0 } all ? all : throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.None"));

    /// <exception cref="CommandException">None has that name.</exception>
    public static async Task<int> PickOneAsync(CommandContext context)
    {
        var all = All(context);
        var name = await context.ValueAsync(new TextPrompt(Wording.Get("Trajectories.EnterName")) { Default = all[^1].Name }).ConfigureAwait(false);
        return context.Document.Current.Sidecar.Trajectories.IndexOf(name) is >= 0 and var found ? found : throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.NotFound", name));
    }
}
