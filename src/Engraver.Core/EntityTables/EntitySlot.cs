namespace Engraver.Core.EntityTables;

/// <summary>The 16 slots of a row (paper 001, Table 2; the reading of slots 13 to 15 is in paper-001-readings.md).</summary>
public static class EntitySlot
{
    /// <summary>Number of slots in a row.</summary>
    public const int Count = 16;

    /// <summary>Property mark: 1 line, 2 circle, 3 arc; beyond the paper 4 ellipse or elliptical arc, 5 spline, with slots 1 to 6 only and the curve in a side
    /// column.</summary>
    public const int Kind = 0;

    public const int StartX = 1;

    public const int StartY = 2;

    public const int StartZ = 3;

    public const int EndX = 4;

    public const int EndY = 5;

    public const int EndZ = 6;

    public const int CentreX = 7;

    public const int CentreY = 8;

    public const int CentreZ = 9;

    public const int Radius = 10;

    /// <summary>Degrees; the angle at which travel starts (an arc traversed backwards has its angles swapped).</summary>
    public const int StartAngle = 11;

    /// <summary>Degrees; a circle ends at its start angle + 360.</summary>
    public const int EndAngle = 12;

    /// <summary>1 is cut first; 0 means not sequenced.</summary>
    public const int SequenceNumber = 13;

    /// <summary>0 in paper 001, and for what is drawn. In a path of operations, what the move is for (<see cref="Sequencing.StrokeRole"/>).</summary>
    public const int Role = 14;

    /// <summary>Signed sweep in degrees, counter-clockwise positive; 0 for a line.</summary>
    public const int Sweep = 15;
}
