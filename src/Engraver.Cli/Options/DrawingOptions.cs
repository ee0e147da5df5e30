using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary>The file argument and the options shared by the drawing verbs.</summary>
internal sealed class DrawingOptions
{
    private static readonly DrawingSettings s_defaults = new();

    private readonly Argument<string> _file = new("FILE") { Description = "The drawing: a DXF of any version, ASCII or binary." };
    private readonly Option<IReadOnlyList<string>?> _layers = new("--layers") { HelpName = "A,B", Description = "Cut only these layers, even when they are off (default: visible, not frozen, plottable).", CustomParser = OptionValue.Names };
    private readonly Option<IReadOnlyList<string>?> _skip = new("--skip-layers") { HelpName = "A,B", Description = "Leave these layers out.", CustomParser = OptionValue.Names };
    private readonly Option<string> _units = Choice("--units", "auto", "Unit of the drawing, whatever it says itself.", "mm", "inch", "auto");
    private readonly Option<CutChoice> _cut = new("--cut") { HelpName = "hatch,mline,leader,helix,solid", Description = "Construction that is to be cut all the same (default: none).", CustomParser = OptionValue.Choices };
    private readonly Option<double> _join = Number("--join-tolerance", "MM", s_defaults.JoinToleranceMm, "Ends this close are one point.", OptionValue.NumberFromZero);
    private readonly Option<double> _maxError = Number("--max-error", "MM", s_defaults.MaxErrorMm, "How far a chord may stand off its curve.", OptionValue.PositiveNumber);
    private readonly Option<Point2D> _start = new("--start") { HelpName = "X,Y", Description = "Drawing point where the tool stands (default 0,0).", CustomParser = OptionValue.Point };
    private readonly Option<string?> _enter = new("--enter") { HelpName = "HANDLE|X,Y", Description = "Entity or point where cutting begins." };
    private readonly Option<string> _order = Choice("--order", "nearest", "Order of the strokes; an inner contour always comes before the one around it.", "drawn", "nearest");
    private readonly Option<bool> _keepDuplicates = new("--keep-duplicates") { Description = "Cut lines that were drawn twice twice." };
    private readonly Option<bool> _recoverArcs = new("--recover-arcs") { Description = "Cut lines that approximate an arc within --max-error as that arc." };
    private readonly Option<string?> _machine = new("--machine") { HelpName = "PROFILE.json", Description = "Machine profile (default: the built-in one)." };
    private readonly Option<double?> _feed = new("--feed") { HelpName = "MM/MIN", Description = "Cutting speed, instead of the profile's.", CustomParser = result => OptionValue.PositiveNumber(result) };

    public void AddTo(Command command)
    {
        command.Arguments.Add(_file);
        AddOptionsTo(command);
    }

    /// <summary>For a verb whose drawing is named by an option of its own.</summary>
    public void AddOptionsTo(Command command)
    {
        foreach (var option in (Option[])[_layers, _skip, _units, _cut, _join, _maxError, _start, _enter, _order, _keepDuplicates, _recoverArcs, _machine, _feed]) command.Options.Add(option);
    }

    public string File(ParseResult parsed) => parsed.GetRequiredValue(_file);

    /// <exception cref="SettingException">The machine profile cannot be used.</exception>
    public DrawingSettings Settings(ParseResult parsed) => new()
    {
        Unit = parsed.GetValue(_units) switch { "mm" => new LengthUnit(4, "mm", "option", 1.0), "inch" => new LengthUnit(1, "in", "option", 25.4), _ => null },
        Cut = parsed.GetValue(_cut),
        Layers = parsed.GetValue(_layers),
        SkippedLayers = parsed.GetValue(_skip) ?? [],
        JoinToleranceMm = parsed.GetValue(_join),
        MaxErrorMm = parsed.GetValue(_maxError),
        Start = parsed.GetValue(_start),
        Enter = Entering(parsed.GetValue(_enter)),
        Order = parsed.GetValue(_order) == "drawn" ? StrokeOrder.Drawn : StrokeOrder.Nearest,
        KeepDuplicates = parsed.GetValue(_keepDuplicates),
        RecoverArcs = parsed.GetValue(_recoverArcs),
        Machine = Machine(parsed),
    };

    private static EnteringPlace? Entering(string? word) => word switch
    {
        null => null,
        _ when OptionValue.TryPoint(word) is { } point => new EnteringPlace.ByPoint(point),
        _ when word.Length <= 16 && word.All(char.IsAsciiHexDigit) => new EnteringPlace.ByHandle(word),
        _ => throw new UsageException($"--enter: '{word}' is neither a point X,Y nor a hexadecimal handle."),
    };

    private static Option<string> Choice(string name, string standard, string description, params string[] values)
    {
        var option = new Option<string>(name) { Description = description, DefaultValueFactory = _ => standard };
        option.AcceptOnlyFromAmong(values);
        return option;
    }

    private static Option<double> Number(string name, string unit, double standard, string description, Func<ArgumentResult, double> parser) =>
        new(name) { HelpName = unit, Description = description, DefaultValueFactory = _ => standard, CustomParser = parser };

    private MachineProfile Machine(ParseResult parsed)
    {
        var profile = parsed.GetValue(_machine) is { } path ? MachineProfileSource.Load(path) : MachineProfile.Default;
        if (parsed.GetValue(_feed) is not { } feed) return profile;
        var fed = profile with { FeedMmPerMinute = feed };
        return MachineProfileValidation.IsFeed(feed, profile, MachineFamily.Limits) ? fed : throw new UsageException($"--feed {feed.ToString("R", CultureInfo.InvariantCulture)}: the machine cuts {MachineProfileValidation.FeedRange(profile, MachineFamily.Limits)} mm/min.");
    }
}
