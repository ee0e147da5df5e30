using Engraver.Core.Trajectories.Formats;

namespace Engraver.Workbench.Documents;

/// <summary>The names of the formats in options.</summary>
public static class TrajectoryFormatName
{
    private static readonly (TrajectoryFormat Format, string Name)[] s_names =
    [
        (TrajectoryFormat.Sace, "sace"),
        (TrajectoryFormat.XpsSpline, "xps-spline"),
        (TrajectoryFormat.XpsLineArc, "xps-linearc"),
        (TrajectoryFormat.XpsPvt, "xps-pvt"),
    ];

    public static IReadOnlyList<string> All => [.. s_names.Select(one => one.Name)];

    public static string Of(TrajectoryFormat format) => s_names.First(one => one.Format == format).Name;

    public static TrajectoryFormat Parse(string name) => s_names.First(one => one.Name == name).Format;
}
