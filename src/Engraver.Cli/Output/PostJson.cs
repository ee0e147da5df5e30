using System.Text.Json.Serialization;
using Engraver.Core.Posts;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver post --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="File">Path of the written text; null when the text is in <paramref name="Text"/>, or when there is no text.</param>
/// <param name="Lines">Number of lines of the text.</param>
/// <param name="Forecast">Null for a target without a forecast.</param>
/// <param name="Programs">One for each tool, in the order in which they are run, where a program cannot change the tool; otherwise absent.</param>
internal sealed record PostJson(string Target, string? File, int Lines, string? Text, PostJson.ForecastJson? Forecast, [property: JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)] IReadOnlyList<PostJson.ProgramJson>? Programs = null)
{
    public static PostJson From(string target, string? file, PostedProgram posted) => new(
        target, posted.Text is null ? null : file, posted.Text?.Count(letter => letter == '\n') ?? 0, file is null ? posted.Text : null, posted.Forecast is { } forecast ? ForecastJson.From(forecast) : null);

    /// <param name="programs">One for each tool.</param>
    public static PostJson From(string target, string? file, IReadOnlyList<ToolProgram> programs)
    {
        List<ProgramJson> all = [.. programs.Select(program => new ProgramJson(program.Tool.Number, program.Section, file is null ? null : program.FileOf(file), program.Posted.Text!.Count(letter => letter == '\n'), file is null ? program.Posted.Text : null))];
        return new PostJson(target, null, all.Sum(program => program.Lines), null, null, all);
    }

    /// <param name="Tool">Number of the tool.</param>
    /// <param name="Section">Number of the section in the job, from 1; null where the tool comes once.</param>
    /// <param name="File">Path of its text; null when the text is in <paramref name="Text"/>.</param>
    internal sealed record ProgramJson(int Tool, int? Section, string? File, int Lines, string? Text);

    /// <param name="Programs">Number of programs into which the job was split.</param>
    /// <param name="StartX">Machine position before the first block, drawing mm.</param>
    /// <param name="MaxError">Largest distance of a cut from the path, mm.</param>
    /// <param name="MaxClosure">Largest gap of a closed contour, mm; null without closed contours.</param>
    internal sealed record ForecastJson(int Programs, double StartX, double StartY, double MaxError, double? MaxClosure, IReadOnlyList<BlockJson> Blocks)
    {
        public static ForecastJson From(PostForecast forecast) => new(
            forecast.Blocks[^1].Part, forecast.Start.X, forecast.Start.Y, forecast.MaxError, forecast.MaxClosure,
            [.. forecast.Blocks.Select(block => new BlockJson(block.Part, block.Number, block.Cutting, block.End.X, block.End.Y, block.Error, block.Closure))]);
    }

    /// <param name="X">Machine position after the block, drawing mm.</param>
    /// <param name="Error">Null for positioning.</param>
    /// <param name="Closure">Null except at the end of a closed contour.</param>
    internal sealed record BlockJson(int Program, int Block, bool Cutting, double X, double Y, double? Error, double? Closure);
}
