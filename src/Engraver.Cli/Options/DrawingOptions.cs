using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Machines.Profiles;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary>The file argument and the options shared by the drawing verbs.</summary>
internal sealed class DrawingOptions
{
    private static readonly DrawingSettings s_defaults = new();

    private readonly Argument<string> _file = new("FILE") { Description = Wording.Get("DrawingOptions.Drawing") };
    private readonly Option<IReadOnlyList<string>?> _layers = Described<IReadOnlyList<string>?>(SettingTable.Layers, OptionValue.Names);
    private readonly Option<IReadOnlyList<string>?> _skip = Described<IReadOnlyList<string>?>(SettingTable.SkippedLayers, OptionValue.Names);
    private readonly Option<string> _units = Choice(SettingTable.Units, "auto");
    private readonly Option<CutChoice> _cut = Described(SettingTable.Cut, OptionValue.Choices);
    private readonly Option<double> _join = Number(SettingTable.JoinTolerance, s_defaults.JoinToleranceMm, OptionValue.NumberFromZero);
    private readonly Option<double> _maxError = Number(SettingTable.MaxError, s_defaults.MaxErrorMm, OptionValue.PositiveNumber);
    private readonly Option<Point2D> _start = Described(SettingTable.Start, OptionValue.Point);
    private readonly Option<FinishPlace> _finish = Described(SettingTable.Finish, OptionValue.Finish);
    private readonly Option<string?> _enter = Described<string?>(SettingTable.Enter);
    private readonly Option<string> _order = Choice(SettingTable.Order, "nearest");
    private readonly Option<bool> _keepDuplicates = Described<bool>(SettingTable.KeepDuplicates);
    private readonly Option<bool> _recoverArcs = Described<bool>(SettingTable.RecoverArcs);
    private readonly Option<string> _kerf = Choice(SettingTable.Kerf, "off");
    private readonly Option<double?> _toolDiameter = Described<double?>(SettingTable.ToolDiameter, result => OptionValue.PositiveNumber(result));
    private readonly Option<string?> _machine = Described<string?>(SettingTable.Machine);
    private readonly Option<double?> _feed = Described<double?>(SettingTable.Feed, result => OptionValue.PositiveNumber(result));

    public void AddTo(Command command)
    {
        command.Arguments.Add(_file);
        AddOptionsTo(command);
    }

    /// <summary>For a verb whose drawing is named by an option of its own.</summary>
    public void AddOptionsTo(Command command)
    {
        foreach (var option in (Option[])[_layers, _skip, _units, _cut, _join, _maxError, _start, _finish, _enter, _order, _keepDuplicates, _recoverArcs, _kerf, _toolDiameter, _machine, _feed]) command.Options.Add(option);
    }

    public string File(ParseResult parsed) => parsed.GetRequiredValue(_file);

    /// <exception cref="SettingException">The machine profile cannot be used.</exception>
    /// <exception cref="UsageException">Options that do not go together.</exception>
    public DrawingSettings Settings(ParseResult parsed) => new()
    {
        Unit = parsed.GetValue(_units) switch { "mm" => LengthUnits.ChosenFrom(4), "inch" => LengthUnits.ChosenFrom(1), _ => null },
        Cut = parsed.GetValue(_cut),
        Layers = parsed.GetValue(_layers),
        SkippedLayers = parsed.GetValue(_skip) ?? [],
        JoinToleranceMm = parsed.GetValue(_join),
        MaxErrorMm = parsed.GetValue(_maxError),
        Start = parsed.GetValue(_start),
        Finish = parsed.GetValue(_finish),
        Enter = Entering(parsed.GetValue(_enter)),
        Order = parsed.GetValue(_order) == "drawn" ? StrokeOrder.Drawn : StrokeOrder.Nearest,
        KeepDuplicates = parsed.GetValue(_keepDuplicates),
        RecoverArcs = parsed.GetValue(_recoverArcs),
        Kerf = Kerf(parsed),
        ToolDiameterMm = parsed.GetValue(_toolDiameter) ?? 0.0,
        Machine = Machine(parsed),
    };

    private KerfSide Kerf(ParseResult parsed)
    {
        var side = Enum.Parse<KerfSide>(parsed.GetValue(_kerf)!, ignoreCase: true);
        return side == KerfSide.Off || parsed.GetValue(_toolDiameter) is not null ? side : throw new UsageException(Wording.Get("DrawingOptions.KerfNeedsDiameter"));
    }

    private static EnteringPlace? Entering(string? word) => word switch
    {
        null => null,
        _ when OptionValue.TryPoint(word) is { } point => new EnteringPlace.ByPoint(point),
        _ when word.Length <= 16 && word.All(char.IsAsciiHexDigit) => new EnteringPlace.ByHandle(word),
        _ => throw new UsageException(Wording.Get("DrawingOptions.InvalidEnter", word)),
    };

    /// <summary>Name, argument and help come from the one description of the setting.</summary>
    private static Option<T> Described<T>(SettingDescription setting, Func<ArgumentResult, T>? parser = null)
    {
        var option = new Option<T>(setting.Flag!) { Description = SettingWording.OnConsole(setting.Meaning) };
        if (setting.Argument is { } argument) option.HelpName = argument;
        if (parser is not null) option.CustomParser = parser;
        return option;
    }

    private static Option<string> Choice(SettingDescription setting, string standard)
    {
        var option = new Option<string>(setting.Flag!) { Description = SettingWording.OnConsole(setting.Meaning), DefaultValueFactory = _ => standard };
        option.AcceptOnlyFromAmong(setting.Argument!.Split('|'));
        return option;
    }

    private static Option<double> Number(SettingDescription setting, double standard, Func<ArgumentResult, double> parser)
    {
        var option = Described(setting, parser);
        option.DefaultValueFactory = _ => standard;
        return option;
    }

    private MachineProfile Machine(ParseResult parsed)
    {
        var profile = parsed.GetValue(_machine) is { } path ? ProfileOption.Load(parsed, path) : MachineProfile.Default;
        if (parsed.GetValue(_feed) is not { } feed) return profile;
        var fed = profile with { FeedMmPerMinute = feed };
        return MachineProfileValidation.IsFeed(feed, profile, MachineFamilies.Driver.Limits) ? fed : throw new UsageException(Wording.Get("DrawingOptions.FeedOutOfRange", feed.ToString("R", CultureInfo.InvariantCulture), MachineProfileValidation.FeedRange(profile, MachineFamilies.Driver.Limits)));
    }
}
