using Engraver.TestKit;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Settings;

/// <summary>The tests of Core use the tolerances of the program, which Core itself does not have.</summary>
public class UsualOptionsTests
{
    [Fact]
    public void The_tolerances_of_the_test_kit_are_the_defaults_of_the_program() =>
        Assert.Equal((DrawingSettings.Default.MaxErrorMm, DrawingSettings.Default.JoinToleranceMm), (UsualOptions.MaxErrorMm, UsualOptions.JoinToleranceMm));
}
