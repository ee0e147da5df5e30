using Engraver.Core.Machines;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>An axis of a profile by its letter, whether X, Y or Z.</summary>
internal static class ProfileAxis
{
    public static MachineAxis Of(MachineProfile profile, char letter) => profile.Axes.All.First(axis => axis.Letter == letter);

    public static MachineProfile With(MachineProfile profile, MachineAxis axis) => profile with
    {
        Axes = profile.Axes.X.Letter == axis.Letter ? profile.Axes with { X = axis } : profile.Axes.Y.Letter == axis.Letter ? profile.Axes with { Y = axis } : profile.Axes with { Z = axis },
    };
}
