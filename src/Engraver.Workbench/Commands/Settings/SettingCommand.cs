using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>A setting that is typed by its name and asks for a new value, like AutoCAD's system variables. Its default is the value it has.</summary>
internal sealed class SettingCommand : ISettingCommand
{
    private readonly NumberPrompt _limits;
    private readonly Func<DrawingSettings, double> _read;
    private readonly Func<DrawingSettings, double, DrawingSettings> _write;

    private SettingCommand(string name, string summary, double least, double most, bool whole, Func<DrawingSettings, double> read, Func<DrawingSettings, double, DrawingSettings> write)
    {
        Info = new CommandInfo(name, CommandGroup.Setting, summary);
        _limits = new NumberPrompt($"Enter new value for {name}") { Least = least, Most = most, Whole = whole };
        (_read, _write) = (read, write);
    }

    public static IReadOnlyList<ICommand> All { get; } =
    [
        new SettingCommand("CNCMAXERR", "How far a chord may stand off its curve, mm.", 1e-9, 1e3, whole: false, s => s.MaxErrorMm, (s, v) => s with { MaxErrorMm = v }),
        new SettingCommand("CNCJOINTOL", "Ends this close are one point, mm.", 0.0, 1e3, whole: false, s => s.JoinToleranceMm, (s, v) => s with { JoinToleranceMm = v }),
        new SettingCommand("CNCDUPLICATES", "1: lines that were drawn twice are cut twice.", 0, 1, whole: true, s => s.KeepDuplicates ? 1 : 0, (s, v) => s with { KeepDuplicates = v == 1 }),
        new SettingCommand("CNCUNITS", "Unit for the next OPEN as a code of $INSUNITS (1 inch, 4 mm ...); 0: what the drawing says.", 0, 24, whole: true, s => s.Unit?.Code ?? 0, (s, v) => s with { Unit = LengthUnits.FromInsUnits(v) is { } unit ? unit with { Source = "option" } : null }),
        new SettingCommand("CNCCUT", "Construction that the next OPEN takes for curves: 1 hatch boundaries, 2 multilines, 4 leaders, 8 helices, 16 edges of solids, added together.", 0, 31, whole: true, s => (int)s.Cut, (s, v) => s with { Cut = (CutChoice)(int)v }),
        new SettingCommand("CNCRECOVER", "1: lines that approximate an arc within CNCMAXERR are cut as that arc.", 0, 1, whole: true, s => s.RecoverArcs ? 1 : 0, (s, v) => s with { RecoverArcs = v == 1 }),
        new SettingCommand("CNCFEED", "Cutting speed along the path, mm/min.", 1e-6, 1e9, whole: false, s => s.Machine.FeedMmPerMinute, (s, v) => s with { Machine = s.Machine with { FeedMmPerMinute = v } }),
        new SettingCommand("CNCVS", "Vector speed, counts/s: the feed in the controller's words.", 1e-3, 1e12, whole: false, s => s.Machine.FeedMmPerMinute / 60.0 * s.Machine.Scale.Smallest, (s, v) => s with { Machine = s.Machine with { FeedMmPerMinute = v * 60.0 / s.Machine.Scale.Smallest } }),
        new SettingCommand("CNCRAPID", "Speed of each axis between strokes, mm/min.", 1e-6, 1e9, whole: false, s => s.Machine.RapidMmPerMinute, (s, v) => s with { Machine = s.Machine with { RapidMmPerMinute = v } }),
        new SettingCommand("CNCVA", "Acceleration and deceleration, counts/s2 in steps of 1024.", 1024, 67107840, whole: true, s => s.Machine.AccelerationCounts, (s, v) => s with { Machine = s.Machine with { AccelerationCounts = (int)v } }),
    ];

    public CommandInfo Info { get; }

    /// <summary>Counts per millimetre by which a feed becomes a vector speed.</summary>
    public string ValueText(CommandContext context) => NumberPrompt.Show(_read(context.Document.Current.Settings));

    /// <exception cref="CommandException">The machine cannot work with that value.</exception>
    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var value = await context.ValueAsync(_limits with { Default = ValueText(context) }).ConfigureAwait(false);
        var state = context.Document.Current;
        var settings = _write(state.Settings, value);
        if (MachineProfileValidation.Check(settings.Machine, MachineFamily.Limits) is [var wrong, ..]) throw new CommandException(CommandFailure.Usage, wrong.Message);
        context.Take(state with { Settings = settings });
    }
}

/// <summary>A command that asks for the new value of one setting, and can say the one it has.</summary>
internal interface ISettingCommand : ICommand
{
    string ValueText(CommandContext context);
}
