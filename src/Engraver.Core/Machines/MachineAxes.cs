namespace Engraver.Core.Machines;

/// <summary>Which axes of the controller move the drawing's X and Y, and their counts per millimetre: the one home of axis letters and of how many axes a job moves.</summary>
public sealed record MachineAxes(MachineAxis X, MachineAxis Y)
{
    public static MachineAxes Default { get; } = new(new MachineAxis('A', 1000.0), new MachineAxis('B', 1000.0));

    /// <summary>Every axis that a job moves, in the order of the drawing's.</summary>
    public IReadOnlyList<MachineAxis> All => [X, Y];

    /// <summary>Their letters in that order.</summary>
    public string Letters => string.Concat(All.Select(axis => axis.Letter));

    public CountsScale Scale => new(X.CountsPerMillimetre, Y.CountsPerMillimetre);

    /// <summary>Axes A and B with these counts per millimetre.</summary>
    public static MachineAxes FromScale(double x, double y) => new(Default.X with { CountsPerMillimetre = x }, Default.Y with { CountsPerMillimetre = y });
}

/// <summary>One axis of the controller.</summary>
/// <param name="Letter">As the controller calls it.</param>
/// <param name="CountsPerMillimetre">Quadrature counts or steps; negative mirrors the axis of the drawing.</param>
public readonly record struct MachineAxis(char Letter, double CountsPerMillimetre);
