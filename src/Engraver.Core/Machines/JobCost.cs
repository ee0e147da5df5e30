namespace Engraver.Core.Machines;

/// <summary>The cost of a job, by its parts.</summary>
public sealed record JobCost(double Time, double Length, double Starts)
{
    public double Total => Time + Length + Starts;
}
