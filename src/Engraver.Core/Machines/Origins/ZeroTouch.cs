using Engraver.Core.Geometry;

namespace Engraver.Core.Machines.Origins;

/// <summary>What the present position of the machine becomes in a work origin: the drawing's zero, a point of the drawing, a touched edge, or the second of two
/// touches.</summary>
public sealed record ZeroTouch
{
    /// <summary>The origin's X is set; an edge sets only the axis that it determines.</summary>
    public bool X { get; init; }

    public bool Y { get; init; }

    /// <summary>The origin's height is set, on a machine that has a Z axis.</summary>
    public bool Z { get; init; }

    /// <summary>The machine is at this point of the drawing, mm.</summary>
    public Point2D Place { get; init; }

    /// <summary>The tool is at this height of the drawing, mm.</summary>
    public double Height { get; init; }

    /// <summary>The tool touches this edge; null for none.</summary>
    public WorkEdge? Edge { get; init; }

    /// <summary>Radius of the tool that touches the edge, mm.</summary>
    public double Radius { get; init; }

    /// <summary>The zero is half-way between this touch, controller counts, and the machine; null for no such touch.</summary>
    public CountsPoint? First { get; init; }

    /// <summary>False where the point or the height is outside the controller's range of counts.</summary>
    public bool IsCountable(CountsScale scale) => scale.IsInRange(Bounds2D.FromCorners(Place, Place), default) && scale.IsHeightInRange(Height);

    /// <summary>The memory with the origin set; axes that are not set keep their values.</summary>
    /// <param name="name">Name of the origin.</param>
    /// <param name="here">Present position of the machine, controller counts.</param>
    public StoredMachineState Set(StoredMachineState memory, string name, CountsPoint here, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(memory);
        ArgumentNullException.ThrowIfNull(profile);
        var (x, y) = ZeroAt(here, profile.Scale);
        return memory.WithOrigin(name, X ? x : null, Y ? y : null, Z && profile.Axes.Z is not null ? here.Z - profile.Scale.ToHeight(Height) : null, StoredAxes.Of(profile));
    }

    private (long? X, long? Y) ZeroAt(CountsPoint here, CountsScale scale)
    {
        if (Edge is { } edge) return EdgeTouch.ZeroAt(here, edge, Radius, scale);
        if (First is { } first) return EdgeTouch.Middle(first, here) is var middle ? (middle.X, middle.Y) : default;
        var at = scale.ToCounts(Place);
        return (here.X - at.X, here.Y - at.Y);
    }
}
