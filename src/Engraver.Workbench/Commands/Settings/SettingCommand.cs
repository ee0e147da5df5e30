using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>A setting that is typed by its name and asks for a new value, like AutoCAD's system variables. Enter keeps the present value.</summary>
internal sealed class SettingCommand : ISettingCommand
{
    private readonly SettingDescription _setting;
    private readonly Func<DrawingSettings, double> _read;
    private readonly Func<DrawingSettings, double, DrawingSettings> _write;

    private SettingCommand(SettingDescription setting, Func<DrawingSettings, double> read, Func<DrawingSettings, double, DrawingSettings> write)
    {
        Info = new CommandInfo(setting.Command!, CommandGroup.Setting);
        (_setting, _read, _write) = (setting, read, write);
    }

    public static IReadOnlyList<ICommand> All { get; } =
    [
        new SettingCommand(SettingTable.MaxError, s => s.MaxErrorMm, (s, v) => s with { MaxErrorMm = v }),
        new SettingCommand(SettingTable.JoinTolerance, s => s.JoinToleranceMm, (s, v) => s with { JoinToleranceMm = v }),
        new SettingCommand(SettingTable.KeepDuplicates, s => s.KeepDuplicates ? 1 : 0, (s, v) => s with { KeepDuplicates = v == 1 }),
        new SettingCommand(SettingTable.Units, s => s.Unit?.Code ?? 0, (s, v) => s with { Unit = LengthUnits.ChosenFrom(v) }),
        new SettingCommand(SettingTable.Cut, s => (int)s.Cut, (s, v) => s with { Cut = (CutChoice)(int)v }),
        new SettingCommand(SettingTable.RecoverArcs, s => s.RecoverArcs ? 1 : 0, (s, v) => s with { RecoverArcs = v == 1 }),
        new SettingCommand(SettingTable.Feed, s => s.Machine.FeedMmPerMinute, (s, v) => s with { Machine = s.Machine with { FeedMmPerMinute = v } }),
        new SettingCommand(SettingTable.VectorSpeed, s => s.Machine.Scale.Coarser.CountsOf(s.Machine.FeedMmPerMinute / 60.0), (s, v) => s with { Machine = s.Machine with { FeedMmPerMinute = s.Machine.Scale.Coarser.LengthOf(v * 60.0) } }),
        new SettingCommand(SettingTable.Rapid, s => s.Machine.RapidMmPerMinute, (s, v) => s with { Machine = s.Machine with { RapidMmPerMinute = v } }),
        new SettingCommand(SettingTable.Acceleration, s => s.Machine.AccelerationCounts, (s, v) => s with { Machine = s.Machine with { AccelerationCounts = (int)v } }),
    ];

    public CommandInfo Info { get; }

    /// <summary>Counts per millimetre by which a feed becomes a vector speed.</summary>
    public string ValueText(CommandContext context) => NumberPrompt.Show(_read(context.Document.Current.Settings));

    /// <exception cref="CommandException">The machine cannot work with that value.</exception>
    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var prompt = new NumberPrompt(Wording.Get("Settings.EnterNewValue", _setting.Command)) { Default = ValueText(context), Least = _setting.Least, Most = _setting.Most, Whole = _setting.Whole };
        var value = await context.ValueAsync(prompt).ConfigureAwait(false);
        var state = context.Document.Current;
        var settings = _write(state.Settings, value);
        if (MachineProfileValidation.Check(settings.Machine, MachineFamilies.Driver.Limits) is [var wrong, ..]) throw new CommandException(CommandFailure.Usage, wrong.Message);
        context.Take(state with { Settings = settings });
    }
}

/// <summary>A command that asks for the new value of one setting and can show the present one.</summary>
internal interface ISettingCommand : ICommand
{
    string ValueText(CommandContext context);
}
