using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Languages;
using Engraver.Core.Offsets;
using Engraver.Core.Trajectories;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Sidecars;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver trajectory</c>: the contours of a drawing as files for the SACE bench or an XPS controller.</summary>
internal sealed class TrajectoryVerb
{
    private readonly VerbHost _host;
    private readonly DrawingOptions _drawing = new();
    private readonly Option<bool> _json = JsonOption.New();
    private readonly Option<string> _folder = new("-o", "--output") { Required = true, HelpName = "DIR", Description = Wording.Get("Trajectory.Folder") };
    private readonly Option<string> _density = Choice("--density", Wording.Get("Trajectory.Density"), "dynamic", "uniform");
    private readonly Option<double> _segment = new("--segment-length") { HelpName = "L", Description = Wording.Get("Trajectory.SegmentLength"), CustomParser = OptionValue.PositiveNumber, DefaultValueFactory = _ => TrajectorySettings.Default.SegmentLengthMm };
    private readonly Option<double?> _offset = new("--offset") { HelpName = "D", Description = Wording.Get("Trajectory.Offset"), CustomParser = result => OptionValue.PositiveNumber(result) };
    private readonly Option<string?> _side = new("--side") { Description = Wording.Get("Trajectory.Side") };
    private readonly Option<double> _passes = new("--passes") { HelpName = "N", Description = Wording.Get("Trajectory.Passes"), CustomParser = OptionValue.IntegerFromOne, DefaultValueFactory = _ => 1.0 };
    private readonly Option<double?> _step = new("--step") { HelpName = "S", Description = Wording.Get("Trajectory.Step"), CustomParser = result => OptionValue.PositiveNumber(result) };
    private readonly Option<string> _corners = Choice("--corners", Wording.Get("Trajectory.Corners"), "stop", "continuous");
    private readonly Option<double> _z = new("--z") { HelpName = "MM", Description = Wording.Get("Trajectory.Z"), CustomParser = OptionValue.AnyNumber, DefaultValueFactory = _ => 0.0 };
    private readonly Option<string> _format = Choice("--format", Wording.Get("Trajectory.Format"), [.. TrajectoryFormatName.All]);

    private readonly Option<bool> _acceptErrors = new("--accept-errors") { Description = Wording.Get("Trajectory.AcceptErrors") };

    private TrajectoryVerb(VerbHost host)
    {
        _host = host;
        _side.AcceptOnlyFromAmong("left", "right", "in", "out");
    }

    public static Command Build(VerbHost host)
    {
        var verb = new TrajectoryVerb(host);
        var command = new Command("trajectory", Wording.Get("Trajectory.Summary"));
        verb._drawing.AddTo(command);
        foreach (var option in (Option[])[verb._folder, verb._json, verb._density, verb._segment, verb._offset, verb._side, verb._passes, verb._step, verb._corners, verb._z, verb._format, verb._acceptErrors]) command.Options.Add(option);
        command.Validators.Add(verb.Check);
        command.SetAction((parsed, stop) => Task.FromResult(verb.Run(parsed, stop)));
        return command;
    }

    private int Run(ParseResult parsed, CancellationToken stop)
    {
        var settings = _drawing.Settings(parsed);
        var read = DrawingFile.Open(_drawing.File(parsed), settings, stop);
        var request = Request(parsed);
        var made = TrajectoryDrawing.Create(read, settings, request);
        var isRefused = made.Trajectories.Any(one => one.File.BrokenLimits.Count > 0 || one.File.VerifiedBound > settings.MaxErrorMm) && !parsed.GetValue(_acceptErrors);
        if (made.Trajectories.Count > 0 && !isRefused) Write(parsed.GetRequiredValue(_folder), made, request);
        if (parsed.GetValue(_json)) ContractJson.Write(_host.Out, TrajectoryListJson.From(made), ContractJson.Default.TrajectoryListJson);
        else TrajectoryListJson.Text(_host.Out, made);
        var code = _host.Report(parsed, read.FileName, made.Diagnostics);
        if (isRefused) _host.Error.WriteLine(Wording.Get("Trajectory.NotWritten"));
        return code;
    }

    private static void Write(string folder, TrajectoryDrawing made, TrajectoryRequest request)
    {
        try
        {
            TrajectoryFolder.Write(folder, made.Trajectories, request.Format);
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            throw new UsageException(Wording.Get("Verbs.CannotWrite", folder, SystemErrorText.FromException(unwritable)), unwritable);
        }
    }

    private TrajectoryRequest Request(ParseResult parsed) => new()
    {
        Format = TrajectoryFormatName.Parse(parsed.GetValue(_format)!),
        Corners = parsed.GetValue(_corners) == "stop" ? CornerMode.Stop : CornerMode.Continuous,
        SegmentLength = IsUniform(parsed.CommandResult) ? parsed.GetValue(_segment) : null,
        Z = parsed.GetValue(_z),
        Offset = parsed.GetValue(_offset) is { } distance ? new TrajectoryOffset(distance, Enum.Parse<OffsetSide>(parsed.GetValue(_side)!, ignoreCase: true), (int)parsed.GetValue(_passes), parsed.GetValue(_step) ?? 0.0) : null,
    };

    /// <summary>A step length alone selects equal steps.</summary>
    private bool IsUniform(CommandResult result) => result.GetResult(_density) is { Implicit: false, Tokens: [var value, ..] } ? value.Value == "uniform" : result.GetResult(_segment) is { Implicit: false };

    /// <summary>Refuses options that require each other if one is missing, instead of ignoring the other.</summary>
    private void Check(CommandResult result)
    {
        bool Has(Option option) => result.GetResult(option) is { Implicit: false };
        string? Given(Option option) => result.GetResult(option) is { Tokens: [var value, ..] } ? value.Value : null;
        if (Given(_format) is ("xps-linearc" or "xps-pvt") and var format)
        {
            if (IsUniform(result)) result.AddError(Wording.Get("Trajectory.UniformIsForSplines", format));
            if (Given(_corners) == "continuous") result.AddError(Wording.Get("Trajectory.ContinuousIsForSplines", format));
        }

        if (Given(_density) == "dynamic" && Has(_segment)) result.AddError(Wording.Get("Trajectory.NeedsUniform"));
        if (!Has(_offset))
        {
            foreach (var option in ((Option[])[_side, _passes, _step]).Where(Has)) result.AddError(Wording.Get("Trajectory.NeedsOffset", option.Name.TrimStart('-')));
        }
        else if (!Has(_side))
        {
            result.AddError(Wording.Get("Trajectory.NeedsSide"));
        }
        else if (Has(_passes) && !Has(_step) && result.GetResult(_passes) is { Tokens: [{ Value: not "1" }] })
        {
            result.AddError(Wording.Get("Trajectory.NeedsStep"));
        }
    }

    private static Option<string> Choice(string name, string description, params string[] values)
    {
        var option = new Option<string>(name) { Description = description, DefaultValueFactory = _ => values[0] };
        option.AcceptOnlyFromAmong(values);
        return option;
    }
}
