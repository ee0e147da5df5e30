using Engraver.Core.Trajectories;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACESETMAXERROR, SACESETSTATICSEGMENTLENGTH, SACESETZPLANE: ask for a length in millimetres for the next trajectories. Enter keeps the current
/// one.</summary>
internal sealed class SaceLengthCommand : ICommand
{
    private readonly Func<TrajectorySettings, double> _read;
    private readonly Func<TrajectorySettings, double, TrajectorySettings> _write;
    private readonly double _least;
    private readonly double _most;

    private SaceLengthCommand(string name, double least, double most, Func<TrajectorySettings, double> read, Func<TrajectorySettings, double, TrajectorySettings> write)
    {
        Info = new CommandInfo(name, CommandGroup.Trajectory);
        (_least, _most, _read, _write) = (least, most, read, write);
    }

    public static IReadOnlyList<ICommand> All { get; } =
    [
        new SaceLengthCommand("SACESETMAXERROR", 1e-6, 1000.0, s => s.MaxErrorMm, (s, v) => s with { MaxErrorMm = v }),
        new SaceLengthCommand("SACESETSTATICSEGMENTLENGTH", 1e-6, 1e6, s => s.SegmentLengthMm, (s, v) => s with { SegmentLengthMm = v }),
        new SaceLengthCommand("SACESETZPLANE", -1e6, 1e6, s => s.PlaneZ, (s, v) => s with { PlaneZ = v }),
    ];

    public CommandInfo Info { get; }

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var now = NumberPrompt.Show(_read(context.Document.Current.Sidecar.Trajectories.Settings));
        var value = await context.ValueAsync(new NumberPrompt(Wording.Get("Settings.EnterNewValue", Info.Name)) { Default = now, Least = _least, Most = _most }).ConfigureAwait(false);
        TrajectoryChange.Settings(context, settings => _write(settings, value));
    }
}

/// <summary>SACETOGGLEDYNAMICDENSITY: Switches between curvature-dependent points and equal steps.</summary>
internal sealed class SaceToggleDensityCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACETOGGLEDYNAMICDENSITY", CommandGroup.Trajectory);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        TrajectoryChange.Settings(context, settings => settings with { DynamicDensity = !settings.DynamicDensity });
        var now = context.Document.Current.Sidecar.Trajectories.Settings;
        context.Say(now.DynamicDensity ? Wording.Get("Trajectories.Dynamic", NumberPrompt.Show(now.MaxErrorMm)) : Wording.Get("Trajectories.Uniform", NumberPrompt.Show(now.SegmentLengthMm)));
        return Task.CompletedTask;
    }
}

/// <summary>SACECORNERS: Selects the treatment of corners: the end of a trajectory, or a rounding within the error.</summary>
internal sealed class SaceCornersCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACECORNERS", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var now = context.Document.Current.Sidecar.Trajectories.Settings.Corners;
        var chosen = await context.ChoiceAsync(Wording.Get("Trajectories.Corners"), Keyword.List(Enum.GetNames<CornerMode>()), now.ToString()).ConfigureAwait(false);
        TrajectoryChange.Settings(context, settings => settings with { Corners = Enum.Parse<CornerMode>(chosen) });
    }
}

/// <summary>Commits a change of trajectories as one undo step.</summary>
internal static class TrajectoryChange
{
    public static void Settings(CommandContext context, Func<TrajectorySettings, TrajectorySettings> change)
    {
        var list = context.Document.Current.Sidecar.Trajectories;
        if (change(list.Settings) is var changed && changed != list.Settings) Take(context, list with { Settings = changed });
    }

    public static void All(CommandContext context, IReadOnlyList<DocumentTrajectory> all) => All(context, all, context.Document.Current.Sidecar.Trajectories.NextNumber);

    /// <param name="next">Number in the name of the next trajectory.</param>
    public static void All(CommandContext context, IReadOnlyList<DocumentTrajectory> all, int next) => Take(context, context.Document.Current.Sidecar.Trajectories with { All = all, NextNumber = next });

    private static void Take(CommandContext context, TrajectoryList list)
    {
        var state = context.Document.Current;
        context.Take(state with { Sidecar = state.Sidecar with { Trajectories = list } });
    }
}
