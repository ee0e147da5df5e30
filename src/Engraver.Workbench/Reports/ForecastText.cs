using Engraver.Core.Posts;

namespace Engraver.Workbench.Reports;

/// <summary>Text report of the positions of a machine whose format rounds coordinates.</summary>
public static class ForecastText
{
    /// <summary>A line for each block and the summary.</summary>
    public static void Write(TextWriter output, PostForecast forecast)
    {
        ArgumentNullException.ThrowIfNull(forecast);
        foreach (var block in forecast.Blocks)
        {
            var error = block.Error is { } off ? Wording.Get("ForecastText.Error", off) : Wording.Get("ForecastText.Positioning");
            output.WriteLine(Wording.Get("ForecastText.Block", block.Part, block.Number, block.End.X, block.End.Y, error, block.Closure is { } open ? Wording.Get("ForecastText.Closure", open) : ""));
        }

        WriteSum(output, forecast);
    }

    /// <summary>Number of blocks, largest error, largest closure.</summary>
    public static void WriteSum(TextWriter output, PostForecast forecast)
    {
        ArgumentNullException.ThrowIfNull(forecast);
        output.WriteLine(Wording.Get("ForecastText.Start", forecast.Start.X, forecast.Start.Y));
        output.WriteLine(Wording.Get("ForecastText.Sum", forecast.Blocks.Count, forecast.Blocks[^1].Part, forecast.MaxError));
        if (forecast.MaxClosure is { } closure) output.WriteLine(Wording.Get("ForecastText.MaximumClosure", closure));
    }
}
