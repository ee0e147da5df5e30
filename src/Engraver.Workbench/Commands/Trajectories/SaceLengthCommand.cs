using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACESETMAXERROR, SACESETSTATICSEGMENTLENGTH, SACESETZPLANE: ask for a length in millimetres for the next trajectories. Enter keeps the current
/// one.</summary>
internal sealed class SaceLengthCommand : ICommand
{
    private readonly Func<TrajectorySettings, double> _read;
    private readonly Func<TrajectorySettings, double, TrajectorySettings> _write;
    private readonly double _min;
    private readonly double _max;

    private SaceLengthCommand(string name, double min, double max, Func<TrajectorySettings, double> read, Func<TrajectorySettings, double, TrajectorySettings> write)
    {
        Info = new CommandInfo(name, CommandGroup.Trajectory);
        (_min, _max, _read, _write) = (min, max, read, write);
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
        var now = NumberPrompt.Format(_read(context.Document.Current.Sidecar.Trajectories.Settings));
        var value = await context.ValueAsync(new NumberPrompt(Wording.Get("Settings.EnterNewValue", Info.Name)) { Default = now, Min = _min, Max = _max }).ConfigureAwait(false);
        TrajectoryChange.Settings(context, settings => _write(settings, value));
    }
}
