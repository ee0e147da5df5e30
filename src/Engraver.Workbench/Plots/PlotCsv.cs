using System.Globalization;

namespace Engraver.Workbench.Plots;

/// <summary>Plots as comma-separated values: a line for each sample of each motion, numbers with a decimal point. Unknown values are empty.</summary>
public static class PlotCsv
{
    private static readonly (PlotQuantity Quantity, string Name)[] s_columns =
    [
        (PlotQuantity.Speed, "speed_mm_per_min"),
        (PlotQuantity.AccelerationX, "acceleration_x_mm_per_s2"),
        (PlotQuantity.AccelerationY, "acceleration_y_mm_per_s2"),
        (PlotQuantity.FollowingError, "following_error_mm"),
        (PlotQuantity.Deviation, "deviation_mm"),
        (PlotQuantity.FeedOverride, "feed_override_percent"),
        (PlotQuantity.LinkLoad, "link_load_percent"),
        (PlotQuantity.Lag, "lag_s"),
    ];

    /// <summary>Writes all quantities that are known of any of the motions, also those of plots that are not visible.</summary>
    public static void Write(IReadOnlyList<PlotSeries> series, TextWriter output)
    {
        ArgumentNullException.ThrowIfNull(output);
        var columns = s_columns.Where(column => series.Any(one => one.Motion.Of(column.Quantity) is not null)).ToArray();
        output.WriteLine(string.Join(',', ["motion", "seconds", "path_mm", "entity", .. columns.Select(column => column.Name)]));
        foreach (var one in series)
        {
            var values = columns.Select(column => one.Motion.Of(column.Quantity)).ToArray();
            var motion = NameOf(one);
            for (var i = 0; i < one.Motion.Count; i++)
            {
                output.Write(string.Create(CultureInfo.InvariantCulture, $"{motion},{one.Motion.Seconds[i]:0.######},{one.Motion.Path[i]:0.######},"));
                if (one.Motion.Entities is { } entities && entities[i] >= 0) output.Write(string.Create(CultureInfo.InvariantCulture, $"{entities[i]}"));
                foreach (var column in values)
                {
                    output.Write(',');
                    if (column is not null && !double.IsNaN(column[i])) output.Write(string.Create(CultureInfo.InvariantCulture, $"{column[i]:0.######}"));
                }

                output.WriteLine();
            }
        }
    }

    private static string NameOf(PlotSeries series) => series.Role switch
    {
        PlotRole.Plan => "plan",
        PlotRole.Run => "run",
        _ => "compared",
    };
}
