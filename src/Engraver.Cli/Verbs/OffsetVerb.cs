using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Offsets;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver offset</c>: the contours of a drawing at a distance, as lines and arcs.</summary>
internal static class OffsetVerb
{
    private const double UsualMitreLimit = 4.0;

    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var json = JsonOption.New();
        var distance = new Option<double>("--distance") { Required = true, HelpName = "MM", Description = Wording.Get("Offset.Distance"), CustomParser = OptionValue.PositiveNumber };
        var side = new Option<string>("--side") { Required = true, Description = Wording.Get("Offset.Side") };
        side.AcceptOnlyFromAmong("left", "right", "in", "out", "both");
        var join = new Option<string>("--join") { Description = Wording.Get("Offset.Join"), DefaultValueFactory = _ => "round" };
        join.AcceptOnlyFromAmong("round", "mitre", "bevel");
        var limit = new Option<double>("--mitre-limit") { HelpName = "FACTOR", Description = Wording.Get("Offset.MitreLimit"), CustomParser = OptionValue.NumberFromOne, DefaultValueFactory = _ => UsualMitreLimit };
        var output = new Option<string?>("-o", "--output") { HelpName = "OUT.dxf", Description = Wording.Get("Offset.WriteDxf") };
        var command = new Command("offset", Wording.Get("Offset.Summary"));
        drawing.AddTo(command);
        foreach (var option in (Option[])[distance, side, join, limit, output, json]) command.Options.Add(option);
        command.SetAction((parsed, stop) =>
        {
            OutputFormat.Check(parsed.GetValue(output), ".dxf");
            var settings = drawing.Settings(parsed);
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var options = new OffsetOptions { Join = Enum.Parse<OffsetJoin>(parsed.GetValue(join)!, ignoreCase: true), MitreLimit = parsed.GetValue(limit), MaxErrorMm = settings.MaxErrorMm };
            var offset = OffsetDrawing.Create(read, settings, parsed.GetValue(distance), Enum.Parse<OffsetSide>(parsed.GetRequiredValue(side), ignoreCase: true), options);
            if (parsed.GetValue(output) is { } path && !DrawingFile.IsUnreadable(read)) host.Write(path, writer => DxfWriter.Write(offset.ToSheet(), writer));
            if (parsed.GetValue(json)) ContractJson.Write(host.Out, OffsetJson.From(offset.Result), ContractJson.Default.OffsetJson);
            else OffsetJson.Text(host.Out, offset);
            return Task.FromResult(host.Report(parsed, read.FileName, offset.Diagnostics));
        });
        return command;
    }
}
