using Engraver.Core.Geometry;

namespace Engraver.Core.Machines.Origins;

/// <summary>The operator's choice of the drawing's zero.</summary>
public abstract record OriginRequest
{
    private OriginRequest()
    {
    }

    /// <summary>The active work origin of the machine.</summary>
    public sealed record ActiveOrigin : OriginRequest;

    /// <summary>A work origin by its name. It must be set; the active one remains selected.</summary>
    /// <param name="Name">One of <see cref="WorkOriginNames.All"/>.</param>
    public sealed record NamedOrigin(string Name) : OriginRequest;

    /// <summary>The machine is at the drawing's start point, and with a Z axis its tool at the height 0 of the drawing.</summary>
    public sealed record PresentPosition : OriginRequest;

    /// <summary>A machine position.</summary>
    /// <param name="Machine">Millimetres from the controller's own zero.</param>
    public sealed record MachinePoint(Point2D Machine) : OriginRequest;
}
