namespace Engraver.Core.Machines.Profiles;

/// <summary>The ends of an axis' travel in a profile file, machine mm.</summary>
internal sealed class TravelDocument
{
    public double? Min { get; set; }

    public double? Max { get; set; }

    public static TravelDocument? From(AxisTravel? travel) => travel is null ? null : new TravelDocument { Min = travel.Min, Max = travel.Max };

    /// <summary>A missing end becomes NaN, which the check of the profile refuses.</summary>
    public AxisTravel ToTravel() => new(Min ?? double.NaN, Max ?? double.NaN);
}
