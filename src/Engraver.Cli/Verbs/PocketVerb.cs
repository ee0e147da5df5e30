using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Geometry;
using Engraver.Core.Pockets;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver pocket</c>: the passes that clear the inside of closed contours.</summary>
internal static class PocketVerb
{
    public static Command Build(VerbHost host)
    {
        var (drawing, options, json) = (new DrawingOptions(), new PocketOptionSet(), JsonOption.New());
        var output = new Option<string?>("-o", "--output") { HelpName = "OUT.dxf", Description = Wording.Get("Pocket.WriteDxf") };
        var command = new Command("pocket", Wording.Get("Pocket.Summary"));
        drawing.AddTo(command);
        options.AddTo(command);
        command.Options.Add(output);
        command.Options.Add(json);
        command.SetAction((parsed, stop) =>
        {
            OutputFormat.Check(parsed.GetValue(output), ".dxf");
            var settings = drawing.Settings(parsed);
            var (chosen, depths) = (options.Pocket(parsed, settings), options.Depths(parsed));
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            options.WarnDeprecated(parsed, host);
            var pocket = PocketDrawing.Create(read, settings, chosen, depths);
            if (parsed.GetValue(output) is { } path && !DrawingFile.IsUnreadable(read)) host.Write(path, writer => DxfWriter.Write(pocket.ToSheet(), writer));
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, PocketJson.From(pocket, chosen, depths), ContractJson.Default.PocketJson);
            else PocketJson.Text(host.Out, pocket, chosen);
            return Task.FromResult(host.Report(parsed, read.FileName, pocket.Diagnostics));
        });
        return command;
    }
}

/// <summary>The options of <c>engraver pocket</c> in addition to those of every drawing verb.</summary>
internal sealed class PocketOptionSet
{
    private const string Wall = "wall";
    private const string Centre = "centre";

    private readonly Option<double> _tool = new("--tool") { Required = true, HelpName = "R", Description = Wording.Get("Pocket.Tool"), CustomParser = OptionValue.PositiveNumber };
    private readonly Option<double?> _stepover = new("--stepover") { HelpName = "F", Description = Wording.Get("Pocket.Stepover"), CustomParser = result => OptionValue.NumberBelowOne(result) };
    private readonly Option<double?> _overlap = new("--overlap") { HelpName = "F", Description = Wording.Get("Pocket.Overlap"), CustomParser = result => OptionValue.NumberBelowOne(result) };
    private readonly Option<string> _strategy = new("--strategy") { Description = Wording.Get("Pocket.Strategy"), DefaultValueFactory = _ => Word(PocketDefaults.Strategy) };
    private readonly Option<double?> _angle = new("--angle") { HelpName = "DEGREES", Description = Wording.Get("Pocket.Angle"), CustomParser = result => OptionValue.AnyNumber(result) };
    private readonly Option<string> _from = new("--from") { Description = Wording.Get("Pocket.From"), DefaultValueFactory = _ => PocketDefaults.FromCentre ? Centre : Wall };
    private readonly Option<double?> _allowance = new("--allowance") { HelpName = "MM", Description = Wording.Get("Pocket.Allowance"), CustomParser = result => OptionValue.NumberFromZero(result) };
    private readonly Option<double?> _depth = new("--depth") { HelpName = "MM", Description = Wording.Get("Pocket.Depth"), CustomParser = result => OptionValue.PositiveNumber(result) };
    private readonly Option<double?> _step = new("--step") { HelpName = "MM", Description = Wording.Get("Pocket.Step"), CustomParser = result => OptionValue.PositiveNumber(result) };
    private readonly Option<string> _entry = new("--entry") { Description = Wording.Get("Pocket.Entry"), DefaultValueFactory = _ => Word(PocketDefaults.Entry) };
    private readonly Option<double> _rampAngle = new("--ramp-angle") { HelpName = "DEGREES", Description = Wording.Get("Pocket.RampAngle"), CustomParser = OptionValue.RampAngle, DefaultValueFactory = _ => PocketDefaults.RampAngleDegrees };

    public void AddTo(Command command)
    {
        _strategy.AcceptOnlyFromAmong("contour", "zigzag");
        _from.AcceptOnlyFromAmong(Wall, Centre);
        _entry.AcceptOnlyFromAmong("plunge", "ramp", "helix");
        foreach (var option in (Option[])[_tool, _stepover, _overlap, _strategy, _angle, _from, _allowance, _depth, _step, _entry, _rampAngle]) command.Options.Add(option);
        command.Validators.Add(result =>
        {
            RequireDepth(result, _step);
            RequireDepth(result, _entry);
        });
    }

    /// <exception cref="UsageException">The allowance is larger than the tool, or the stepover is missing or given twice.</exception>
    public PocketOptions Pocket(ParseResult parsed, DrawingSettings settings) => new()
    {
        ToolRadius = parsed.GetRequiredValue(_tool),
        Stepover = Stepover(parsed),
        Strategy = Enum.Parse<PocketStrategy>(parsed.GetValue(_strategy)!, ignoreCase: true),
        Angle = Angle.FromDegrees(parsed.GetValue(_angle) ?? PocketDefaults.AngleDegrees),
        FromCentre = parsed.GetValue(_from) == Centre,
        Allowance = (parsed.GetValue(_allowance) ?? PocketDefaults.Allowance) is var allowance && allowance <= parsed.GetRequiredValue(_tool)
            ? allowance
            : throw new UsageException(Wording.Get("Pocket.AllowanceAboveTool")),
        MaxErrorMm = settings.MaxErrorMm,
        JoinToleranceMm = settings.JoinToleranceMm,
    };

    private double Stepover(ParseResult parsed) => (parsed.GetValue(_stepover), parsed.GetValue(_overlap)) switch
    {
        ({ } given, null) => given,
        (null, { } given) => given,
        _ => throw new UsageException(Wording.Get("Pocket.StepoverOnce")),
    };

    /// <summary>Warns on standard error that the stepover was given by its deprecated name.</summary>
    public void WarnDeprecated(ParseResult parsed, VerbHost host)
    {
        if (parsed.GetValue(_overlap) is { } given && !GlobalOptions.IsErrorsOnly(parsed)) host.Error.WriteLine(Wording.Get("Pocket.OverlapDeprecated", given));
    }

    public PocketDepths Depths(ParseResult parsed) => new()
    {
        Depth = parsed.GetValue(_depth) ?? PocketDefaults.Depth,
        Step = parsed.GetValue(_step) ?? PocketDefaults.Step,
        Entry = Enum.Parse<PocketEntry>(parsed.GetValue(_entry)!, ignoreCase: true),
        RampAngle = Angle.FromDegrees(parsed.GetValue(_rampAngle)),
    };

    private static string Word<T>(T choice)
        where T : struct, Enum => Enum.GetName(choice)!.ToLowerInvariant();

    private void RequireDepth(CommandResult result, Option option)
    {
        if (result.GetResult(option) is { Implicit: false } && result.GetResult(_depth) is null) result.AddError(Wording.Get("Pocket.NeedsDepth", option.Name));
    }
}
