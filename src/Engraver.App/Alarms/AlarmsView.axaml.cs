using Avalonia.Controls;

namespace Engraver.App.Alarms;

/// <summary>The page of alarms.</summary>
public partial class AlarmsView : UserControl
{
    public AlarmsView() => InitializeComponent();
}
